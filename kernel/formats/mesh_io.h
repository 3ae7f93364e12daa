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

/// Reads the mesh in a file; the extension tells its format. PLY and STL may be text or binary;
/// exactly equal points of an STL file are welded. Polygons are triangulated. Whether the mesh is
/// closed and manifold is left to `audit`. \throw InvalidInput if the extension is unknown, the
/// file is missing, incomplete, damaged or without triangles, or has coordinates that are not
/// finite or indices out of range; the message gives the file, the line or element, and what to do
Triangles read_triangles(const std::filesystem::path& path);

/// Writes the mesh in the format of the extension: OBJ, OFF or STL as text with the digits that
/// give back the same bits, PLY as binary doubles. A file at `path` is replaced only once the whole
/// mesh is written. STL has no indices: vertices come back welded, in the order of use. \throw
/// InvalidInput if the extension is unknown, the mesh has positions that are not finite or indices
/// out of range, or the file cannot be written
void write_triangles(const std::filesystem::path& path, const Triangles& surface);

}  // namespace suture
