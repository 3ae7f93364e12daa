// Meshes named on the command line: read, repaired where asked, and judged.
#include "sims/cli/inputs.h"

#include <fmt/format.h>

#include <algorithm>

#include "kernel/audit.h"
#include "kernel/errors.h"
#include "kernel/formats/mesh_io.h"
#include "kernel/repair/repair.h"
#include "kernel/shapes/transform.h"

namespace suture::sims {

namespace {

std::string extension_of(const std::filesystem::path& file) {
  std::string extension = file.extension().string();
  std::transform(extension.begin(), extension.end(), extension.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return extension;
}

}  // namespace

Triangles read_input(const std::string& file, const Inputs& inputs) {
  Triangles surface = read_triangles(file);
  if (!inputs.mend) return surface;
  for (const std::string& done : repair(surface).in_words())
    fmt::print(stderr, "{}: {}\n", file, done);
  return surface;
}

Triangles read_union(const Inputs& inputs) {
  std::vector<Triangles> surfaces;
  for (const std::string& file : inputs.files) {
    surfaces.push_back(read_input(file, inputs));
    require_usable(surfaces.back(), file);
  }
  return merged(surfaces);
}

void require_folder_of(const std::filesystem::path& file) {
  const std::filesystem::path folder = file.has_parent_path() ? file.parent_path() : ".";
  if (!std::filesystem::is_directory(folder))
    throw InvalidInput(file.string() + ": the folder " + folder.string() +
                       " is not there; make it first, or choose another");
  if (std::filesystem::is_directory(file))
    throw InvalidInput(file.string() + ": is a folder; give a file's name");
}

void require_writable_mesh(const std::filesystem::path& file) {
  if (has_mesh_extension(file)) return require_folder_of(file);
  throw InvalidInput(file.string() + ": a mesh cannot be written with the extension \"" +
                     extension_of(file) + "\"; use " + mesh_extensions_in_words());
}

void require_writable_picture(const std::filesystem::path& file) {
  if (extension_of(file) != ".png")
    throw InvalidInput(file.string() + ": pictures are PNG; give a name that ends in .png");
  require_folder_of(file);
}

bool same_file(const std::filesystem::path& a, const std::filesystem::path& b) {
  std::error_code error;
  if (std::filesystem::equivalent(a, b, error)) return true;
  const auto first = std::filesystem::weakly_canonical(std::filesystem::absolute(a), error);
  if (error) return false;
  const auto second = std::filesystem::weakly_canonical(std::filesystem::absolute(b), error);
  return !error && first == second;
}

std::filesystem::path reproducer_beside(const std::filesystem::path& out) {
  std::filesystem::path file = out;
  return file.replace_filename(out.stem().string() + ".reproducer.ply");
}

}  // namespace suture::sims
