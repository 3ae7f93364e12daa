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
  const std::string advice = "check that its folder exists and can be written to";
  if (!path.has_filename()) throw refusal(path, "this is not the name of a file", "name a file");
  std::error_code error;
  if (std::filesystem::is_directory(path, error))
    throw refusal(path, "this is a folder", "name a file in it");
  std::filesystem::path temporary = path;
  temporary += ".part" + std::to_string(::getpid());
  File file(std::fopen(temporary.c_str(), "wb"));
  if (!file) throw refusal(path, std::string("cannot be written: ") + std::strerror(errno), advice);
  bool good = std::fwrite(bytes.data(), 1, bytes.size(), file.get()) == bytes.size();
  good &= std::fflush(file.get()) == 0;
  const int reason = errno;
  good &= std::fclose(file.release()) == 0;
  if (!good) {
    std::filesystem::remove(temporary, error);
    throw refusal(path, std::string("could not be written whole: ") + std::strerror(reason),
                  "check the space on the disk");
  }
  std::filesystem::rename(temporary, path, error);
  if (error) {
    const std::string why = error.message();
    std::filesystem::remove(temporary, error);
    throw refusal(path, "cannot be written: " + why, advice);
  }
}

}  // namespace suture
