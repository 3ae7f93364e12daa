// Meshes named on the command line: read, repaired where asked, and judged.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "kernel/triangles.h"

namespace suture::sims {

/// Input files, and whether to mend what has one right answer.
struct Inputs {
  std::vector<std::string> files;
  bool mend = false;
};

/// One file's mesh; what a repair did is said on standard error.
/// \throw InvalidInput as read_triangles
Triangles read_input(const std::string& file, const Inputs& inputs);

/// All files' meshes as one surface. \throw InvalidInput if one is no closed oriented manifold
Triangles read_union(const Inputs& inputs);

/// \throw InvalidInput unless the extension is one that can be written and the folder is there
void require_writable_mesh(const std::filesystem::path& file);

/// \throw InvalidInput unless it ends in .png and the folder is there
void require_writable_picture(const std::filesystem::path& file);

/// Whether two names lead to the same file, there or yet to be written.
bool same_file(const std::filesystem::path& a, const std::filesystem::path& b);

/// \throw InvalidInput unless the folder of `file` is there
void require_folder_of(const std::filesystem::path& file);

/// The file beside `out` in which the input of a failed computation is kept.
std::filesystem::path reproducer_beside(const std::filesystem::path& out);

}  // namespace suture::sims
