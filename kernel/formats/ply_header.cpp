// Parsing and checking the header of a PLY file.
#include "kernel/formats/ply_header.h"

#include <array>
#include <utility>

#include "kernel/lattice.h"

namespace suture {

namespace {

constexpr std::array<std::pair<std::string_view, PlyType>, 16> kTypes = {
    {{"char", PlyType::int8},
     {"int8", PlyType::int8},
     {"uchar", PlyType::uint8},
     {"uint8", PlyType::uint8},
     {"short", PlyType::int16},
     {"int16", PlyType::int16},
     {"ushort", PlyType::uint16},
     {"uint16", PlyType::uint16},
     {"int", PlyType::int32},
     {"int32", PlyType::int32},
     {"uint", PlyType::uint32},
     {"uint32", PlyType::uint32},
     {"float", PlyType::float32},
     {"float32", PlyType::float32},
     {"double", PlyType::float64},
     {"float64", PlyType::float64}}};

PlyType read_type(TextLines& text) {
  const std::string_view token = text.token();
  for (const auto& [name, type] : kTypes)
    if (name == token) return type;
  throw text.refusal(in_quotes(token) + " is no type of a PLY property",
                     "the header is damaged: export the mesh again");
}

bool whole(PlyType type) { return type != PlyType::float32 && type != PlyType::float64; }

PlyFormat read_format(TextLines& text) {
  const std::string_view token = text.token();
  if (token == "ascii") return PlyFormat::ascii;
  if (token == "binary_little_endian") return PlyFormat::little_endian;
  if (token == "binary_big_endian") return PlyFormat::big_endian;
  throw text.refusal(in_quotes(token) + " is no format of a PLY file",
                     "the header is damaged: export the mesh again");
}

PlyElement read_element(TextLines& text) {
  PlyElement element;
  element.name = text.token();
  element.count = text.integer("the count of an element");
  element.header_line = text.line();
  if (element.count < 0)
    throw text.refusal("the count of " + in_quotes(element.name) + " is negative",
                       "the header is damaged: export the mesh again");
  return element;
}

PlyProperty read_property(TextLines& text) {
  TextLines ahead = text;
  PlyProperty property;
  property.list = ahead.token() == "list";
  if (property.list) {
    text.token();
    property.count_type = read_type(text);
    if (!whole(property.count_type))
      throw text.refusal("the length of a list is not of a whole type",
                         "the header is damaged: export the mesh again");
  }
  property.type = read_type(text);
  property.name = text.token();
  return property;
}

void require_surface(const PlyHeader& header, const TextLines& text) {
  int vertices = 0, faces = 0;
  for (const PlyElement& e : header.elements) {
    if (e.name == "vertex") {
      ++vertices;
      for (const char* axis : kAxisName)
        if (e.find(axis) == e.properties.size() || e.properties[e.find(axis)].list)
          throw text.refusal(std::string("the vertices have no coordinate ") + axis,
                             "export the mesh with x, y and z");
    } else if (e.name == "face") {
      ++faces;
      const std::size_t i = std::min(e.find("vertex_indices"), e.find("vertex_index"));
      if (i == e.properties.size() || !e.properties[i].list || !whole(e.properties[i].type))
        throw text.refusal("the faces have no list 'vertex_indices' of whole numbers",
                           "export the mesh as polygons");
    }
  }
  if (vertices != 1 || faces != 1)
    throw text.refusal("the file declares 'vertex' " + std::to_string(vertices) +
                           " times and 'face' " + std::to_string(faces) + " times, not once each",
                       "export the mesh as one surface of polygons, without strips");
}

}  // namespace

std::size_t PlyElement::find(std::string_view property) const {
  std::size_t i = 0;
  while (i < properties.size() && properties[i].name != property) ++i;
  return i;
}

PlyHeader read_ply_header(TextLines& text) {
  PlyHeader header;
  if (!text.next_line() || text.token() != "ply")
    throw text.refusal("the file does not start with 'ply'",
                       "use the extension of its real format, or export it again");
  bool has_format = false;
  while (text.next_line()) {
    const std::string_view keyword = text.token();
    if (keyword == "format") {
      header.format = read_format(text);
      has_format = true;
    } else if (keyword == "element") {
      header.elements.push_back(read_element(text));
    } else if (keyword == "property" && !header.elements.empty()) {
      header.elements.back().properties.push_back(read_property(text));
    } else if (keyword == "end_header") {
      if (!has_format) throw text.refusal("the header names no format", "export the mesh again");
      require_surface(header, text);
      return header;
    } else if (keyword != "comment" && keyword != "obj_info") {
      throw text.refusal(in_quotes(keyword) + " does not belong in a PLY header",
                         "the header is damaged: export the mesh again");
    }
  }
  throw text.refusal("the file ends within its header",
                     "it is incomplete: fetch or export it again");
}

}  // namespace suture
