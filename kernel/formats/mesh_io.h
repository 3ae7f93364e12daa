// Meshes in and out of files: OBJ, OFF, PLY and STL, to the last bit.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

#include "kernel/triangles.h"

namespace suture {

/// The extensions of mesh files, in the order in which files of one name are preferred.
inline constexpr std::string_view kMeshExtensions[] = {".ply", ".obj", ".off", ".stl"};

/// All of them as messages list them: ".ply, .obj, .off or .stl".
std::string mesh_extensions_in_words();

/// Whether the name ends in one of them, in letters of either case.
bool has_mesh_extension(const std::filesystem::path& path);

/// The mesh in a file, its format by the extension: .obj, .off, .ply (text or binary) or .stl (text
/// or binary; exactly equal points are welded). Polygons are triangulated; whether the
/// result is closed and manifold is left to `audit`. \throw InvalidInput if the file is missing,
/// incomplete, damaged, empty of triangles, or has coordinates that are not finite or indices out
/// of range: with file, line or element, count and what to do
Triangles read_triangles(const std::filesystem::path& path);

/// Writes OBJ, OFF or STL as text with the digits that give back the same bits, PLY as binary
/// doubles. What is at `path` is replaced only once the whole mesh is written. STL has no indices:
/// vertices come back in the order of use, welded. \throw InvalidInput if the extension is another,
/// the mesh could not be read again, or the file cannot be written
void write_triangles(const std::filesystem::path& path, const Triangles& surface);

}  // namespace suture
