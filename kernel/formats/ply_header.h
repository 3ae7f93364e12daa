// The header of a PLY file: its elements, their properties, and how their values are stored.
#pragma once

#include <string>
#include <vector>

#include "kernel/formats/text.h"

namespace suture {

enum class PlyFormat { ascii, little_endian, big_endian };
enum class PlyType { int8, uint8, int16, uint16, int32, uint32, float32, float64 };

struct PlyProperty {
  std::string name;
  PlyType type = PlyType::int8;
  bool list = false;
  PlyType count_type = PlyType::int8;  ///< the type of a list's length
};

struct PlyElement {
  std::string name;
  std::int64_t count = 0;
  std::vector<PlyProperty> properties;
  std::size_t header_line = 0;

  /// The property's place among the others, or their number where there is none.
  std::size_t find(std::string_view property) const;
};

struct PlyHeader {
  PlyFormat format = PlyFormat::ascii;
  std::vector<PlyElement> elements;
};

/// Reads the header, end_header included; `text` then stands at the first line or byte of the body.
/// \throw InvalidInput if it is no header, or names no vertices with x, y and z or no faces with
/// indices
PlyHeader read_ply_header(TextLines& text);

}  // namespace suture
