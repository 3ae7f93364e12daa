// Small meshes as text, and the reading of them from a file: for the tests of the formats.
#pragma once

#include <string>

#include "kernel/files.h"
#include "kernel/formats/mesh_io.h"
#include "tests/kernel/folder.h"

namespace suture {

/// The mesh in a file of that name and text.
inline Triangles read_text(const TemporaryFolder& folder, const std::string& name,
                           const std::string& text) {
  write_file(folder / name, text);
  return read_triangles(folder / name);
}

/// The header of a PLY file of that format.
inline std::string header(const std::string& format, int vertices, int faces) {
  return "ply\nformat " + format + " 1.0\ncomment made by a test\nelement vertex " +
         std::to_string(vertices) +
         "\nproperty double x\nproperty double y\nproperty double z\nelement face " +
         std::to_string(faces) + "\nproperty list uchar int vertex_indices\nend_header\n";
}

inline const std::string kObj =
    "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 3 2\nf 1 2 4\nf 2 3 4\nf 1 4 3\n";
inline const std::string kOff =
    "OFF\n4 4 6\n0 0 0\n1 0 0\n0 1 0\n0 0 1\n3 0 2 1\n3 0 1 3\n3 1 2 3\n3 0 3 2\n";
inline const std::string kPly =
    header("ascii", 4, 4) + "0 0 0\n1 0 0\n0 1 0\n0 0 1\n3 0 2 1\n3 0 1 3\n3 1 2 3\n3 0 3 2\n";

}  // namespace suture
