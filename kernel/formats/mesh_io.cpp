// Formats are found by extension. CGAL's readers (5.5.1, tried on the files of the tests) will not
// do: they report false instead of a line and a reason, accept NaN in binary PLY and STL, indices
// out of range in PLY and bytes after the last element, and refuse OBJ with weights or joined
// lines.
#include "kernel/formats/mesh_io.h"

#include <algorithm>
#include <string>

#include "kernel/errors.h"
#include "kernel/files.h"
#include "kernel/formats/formats.h"

namespace suture {

namespace {

struct Format {
  std::string_view extension;
  Triangles (*parse)(std::string_view, const std::string&);
  std::string (*format)(const Triangles&);
};
constexpr Format kFormats[] = {{kMeshExtensions[0], parse_ply, format_ply},
                               {kMeshExtensions[1], parse_obj, format_obj},
                               {kMeshExtensions[2], parse_off, format_off},
                               {kMeshExtensions[3], parse_stl, format_stl}};
static_assert(std::size(kFormats) == std::size(kMeshExtensions));

/// The extension in lower case.
std::string extension_of(const std::filesystem::path& path) {
  std::string extension = path.extension().string();
  std::transform(extension.begin(), extension.end(), extension.begin(), [](char c) {
    return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
  });
  return extension;
}

const Format& format_of(const std::filesystem::path& path) {
  const std::string extension = extension_of(path);
  for (const Format& f : kFormats)
    if (f.extension == extension) return f;
  throw InvalidInput(path.string() + ": " +
                     (extension.empty() ? "the name has no extension"
                                        : "the extension '" + extension + "' is unknown") +
                     "; use " + mesh_extensions_in_words());
}

void require_readable_again(const Triangles& surface, const std::string& name) {
  for (std::size_t v = 0; v < surface.positions.size(); ++v)
    if (!surface.positions[v].allFinite())
      throw InvalidInput(name + ": vertex " + std::to_string(v) +
                         " is not finite, so the mesh is not written; mend it first");
  for (std::size_t i = 0; i < surface.triangles.size(); ++i)
    for (const std::uint32_t v : surface.triangles[i])
      if (v >= surface.positions.size())
        throw InvalidInput(name + ": triangle " + std::to_string(i) + " has the vertex index " +
                           std::to_string(v) + ", but there are " +
                           std::to_string(surface.positions.size()) +
                           " vertices, so the mesh is not written; mend it first");
}

}  // namespace

std::string mesh_extensions_in_words() {
  std::string words;
  for (const std::string_view extension : kMeshExtensions) {
    if (!words.empty()) words += extension == std::end(kMeshExtensions)[-1] ? " or " : ", ";
    words += extension;
  }
  return words;
}

bool has_mesh_extension(const std::filesystem::path& path) {
  return std::ranges::find(kMeshExtensions, extension_of(path)) != std::end(kMeshExtensions);
}

Triangles read_triangles(const std::filesystem::path& path) {
  const Format& format = format_of(path);
  const std::string bytes = read_file(path);
  if (bytes.empty())
    throw InvalidInput(path.string() + ": the file is empty; fetch or export it again");
  return format.parse(bytes, path.string());
}

void write_triangles(const std::filesystem::path& path, const Triangles& surface) {
  const Format& format = format_of(path);
  require_readable_again(surface, path.string());
  if (format.parse == parse_stl) require_apart_as_stl(surface, path.string());
  write_file(path, format.format(surface));
}

}  // namespace suture
