// Reading and replacing whole files, with the system's own reason in each refusal.
#include "kernel/files.h"

#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <memory>

#include "kernel/errors.h"

namespace suture {

namespace {

struct Close {
  void operator()(std::FILE* file) const { std::fclose(file); }
};
using File = std::unique_ptr<std::FILE, Close>;

InvalidInput refusal(const std::filesystem::path& path, const std::string& what,
                     const std::string& advice) {
  return InvalidInput(path.string() + ": " + what + "; " + advice);
}

/// Writes straight to `file`; a refusal speaks of `name`.
void put(const std::filesystem::path& file, const std::filesystem::path& name,
         std::string_view bytes) {
  File open(std::fopen(file.c_str(), "wb"));
  if (!open)
    throw refusal(name, std::string("cannot be written: ") + std::strerror(errno),
                  "check that its folder exists and can be written to");
  bool good = std::fwrite(bytes.data(), 1, bytes.size(), open.get()) == bytes.size();
  good &= std::fflush(open.get()) == 0;
  const int reason = errno;
  good &= std::fclose(open.release()) == 0;
  if (!good)
    throw refusal(name, std::string("could not be written whole: ") + std::strerror(reason),
                  "check the space on the disk");
}

/// The file that `path` leads to by symbolic links, whether it is there or not.
std::filesystem::path behind_links(std::filesystem::path path) {
  constexpr int most = 40;  // as the system allows
  std::error_code error;
  for (int i = 0; i < most && std::filesystem::is_symlink(path, error); ++i) {
    const auto next = std::filesystem::read_symlink(path, error);
    if (error) break;
    path = path.parent_path() / next;  // an absolute `next` replaces it all
  }
  return path;
}

}  // namespace

std::string read_file(const std::filesystem::path& path) {
  std::error_code error;
  const auto status = std::filesystem::status(path, error);
  if (status.type() == std::filesystem::file_type::not_found)
    throw refusal(path, "there is no such file", "check the name");
  if (std::filesystem::is_directory(status))
    throw refusal(path, "this is a folder", "name a file in it");
  const File file(std::fopen(path.c_str(), "rb"));
  if (!file)
    throw refusal(path, std::string("cannot be opened: ") + std::strerror(errno),
                  "check its permissions");
  std::string bytes;
  const auto size = std::filesystem::file_size(path, error);
  if (!error) bytes.reserve(static_cast<std::size_t>(size) + 1);
  char block[1 << 16];
  while (const std::size_t n = std::fread(block, 1, sizeof block, file.get()))
    bytes.append(block, n);
  if (std::ferror(file.get()))
    throw refusal(path, std::string("cannot be read: ") + std::strerror(errno), "check the disk");
  return bytes;
}

void write_file(const std::filesystem::path& path, std::string_view bytes) {
  namespace fs = std::filesystem;
  if (!path.has_filename()) throw refusal(path, "this is not the name of a file", "name a file");
  std::error_code error;
  const fs::file_status status = fs::status(path, error);
  if (fs::is_directory(status)) throw refusal(path, "this is a folder", "name a file in it");
  if (fs::is_other(status)) return put(path, path, bytes);
  const fs::path target = behind_links(path);
  fs::path temporary = target;
  temporary += ".part" + std::to_string(::getpid());
  try {
    put(temporary, path, bytes);
  } catch (const InvalidInput&) {
    fs::remove(temporary, error);
    throw;
  }
  fs::rename(temporary, target, error);
  if (error) {
    const std::string why = error.message();
    fs::remove(temporary, error);
    throw refusal(path, "cannot be written: " + why,
                  "check that its folder exists and can be written to");
  }
}

}  // namespace suture
