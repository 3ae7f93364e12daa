// The mesh formats, from bytes and to bytes. `file` is the name for messages.
#pragma once

#include <string>
#include <string_view>

#include "kernel/triangles.h"

namespace suture {

/// Each throws InvalidInput with file, line or element, count and what to do.
Triangles parse_obj(std::string_view bytes, const std::string& file);
Triangles parse_off(std::string_view bytes, const std::string& file);
Triangles parse_ply(std::string_view bytes, const std::string& file);
Triangles parse_stl(std::string_view bytes, const std::string& file);

/// Each gives a file that reads back with the same bits. \pre finite positions, indices in range
std::string format_obj(const Triangles& surface);
std::string format_off(const Triangles& surface);
std::string format_ply(const Triangles& surface);  ///< binary, little endian, doubles
/// Text, since binary STL holds floats only. Vertices come back in the order of first use, equal
/// ones welded, and those in no triangle are lost: STL has no indices.
std::string format_stl(const Triangles& surface);

}  // namespace suture
