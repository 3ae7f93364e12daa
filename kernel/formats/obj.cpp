// Wavefront OBJ: v and f are read; keywords that only colour or group the surface are passed over.
#include <algorithm>
#include <array>

#include "kernel/formats/builder.h"
#include "kernel/formats/formats.h"
#include "kernel/formats/text.h"

namespace suture {

namespace {

constexpr std::array<std::string_view, 22> kPassedOver = {
    "vt",  "vn",   "vp",     "g",          "o",         "s",     "mg",       "usemtl",
    "l",   "p",    "mtllib", "usemap",     "maplib",    "bevel", "c_interp", "d_interp",
    "lod", "bmat", "step",   "shadow_obj", "trace_obj", "csh"};

// The vertex of a face's corner: "v", "v/vt", "v//vn" or "v/vt/vn". In the file v counts from 1, or
// from −1 backwards.
std::int64_t corner(std::string_view token, const TextLines& text, std::size_t positions) {
  const auto index = parse_integer(token.substr(0, token.find('/')));
  if (!index || *index == 0)
    throw text.refusal("a face has the vertex " + in_quotes(token) +
                           ", which is no index from 1 or from -1 backwards",
                       "export the mesh again");
  if (*index > 0) return *index - 1;
  const std::int64_t counted = static_cast<std::int64_t>(positions) + *index;
  if (counted < 0)
    throw text.refusal("a face has the vertex index " + std::to_string(*index) + ", but only " +
                           std::to_string(positions) + " vertices come before it",
                       "the file is incomplete or damaged: export it again");
  return counted;
}

}  // namespace

Triangles parse_obj(std::string_view bytes, const std::string& file) {
  TextLines text(bytes, file, {.comment = '#', .continued = true});
  SurfaceBuilder builder(file, 1);
  std::vector<std::int64_t> face;
  while (text.next_line()) {
    const std::string_view keyword = text.token();
    if (keyword == "v") {
      const double x = text.number("x of a vertex"), y = text.number("y of a vertex");
      builder.add_position({x, y, text.number("z of a vertex")}, text.line());
    } else if (keyword == "f") {
      face.clear();
      for (std::string_view t = text.token(); !t.empty(); t = text.token())
        face.push_back(corner(t, text, builder.positions()));
      builder.add_face(face, text.line());
    } else if (std::find(kPassedOver.begin(), kPassedOver.end(), keyword) == kPassedOver.end()) {
      throw text.refusal(in_quotes(keyword) + " is not a keyword of an OBJ mesh",
                         "export the mesh again as polygons");
    }
  }
  return std::move(builder).finish();
}

std::string format_obj(const Triangles& surface) {
  std::string text;
  for (const Point& p : surface.positions) {
    text += 'v';
    for (const double x : p) append_number(text += ' ', x);
    text += '\n';
  }
  for (const Triangle& t : surface.triangles) {
    text += 'f';
    for (const std::uint32_t v : t) append_integer(text += ' ', std::uint64_t{v} + 1);
    text += '\n';
  }
  return text;
}

}  // namespace suture
