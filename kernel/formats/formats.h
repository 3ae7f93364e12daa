// The four mesh formats, each from bytes and to bytes.
#pragma once

#include <string>
#include <string_view>

#include "kernel/triangles.h"

namespace suture {

/// Each reads a whole file of its format; `file` stands for it in messages. The surface may be open
/// or non-manifold. \throw InvalidInput if the file is incomplete, damaged or without triangles, or
/// has coordinates that are not finite or indices out of range; the message gives the file, the
/// line or element, the count, and what to do
Triangles parse_obj(std::string_view bytes, const std::string& file);
Triangles parse_off(std::string_view bytes, const std::string& file);
Triangles parse_ply(std::string_view bytes, const std::string& file);
Triangles parse_stl(std::string_view bytes, const std::string& file);

/// Each writes a whole file that reads back with the same bits.
/// \pre finite positions, indices in range
std::string format_obj(const Triangles& surface);
std::string format_off(const Triangles& surface);
/// Writes PLY as binary doubles, the lowest byte first.
std::string format_ply(const Triangles& surface);
/// Writes STL as text, since binary STL holds floats only. STL has no indices: vertices come back
/// in the order of first use, equal ones welded, and those in no triangle are lost.
std::string format_stl(const Triangles& surface);

/// Refuses a closed manifold that is none once equal points are welded, or points that round to the
/// same floats, as STL's readers do: bodies that touch along an edge or a face. Triangles that
/// collapse in floats do not count, since such readers drop them. `name` stands for the file.
/// \throw InvalidInput with the first fault that a reader would find, and what to do
void require_apart_as_stl(const Triangles& surface, const std::string& name);

}  // namespace suture
