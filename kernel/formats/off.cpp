// Geomview's OFF as text, with or without normals, colours and texture coordinates.
#include "kernel/formats/builder.h"
#include "kernel/formats/formats.h"
#include "kernel/formats/text.h"

namespace suture {

namespace {

struct Counts {
  std::int64_t vertices = 0, faces = 0;
};

Counts header(TextLines& text) {
  text.next_line();
  std::string_view keyword = text.token();
  for (const std::string_view extra : {"ST", "C", "N"})  // values that follow each position
    if (keyword.starts_with(extra)) keyword.remove_prefix(extra.size());
  if (keyword != "OFF")
    throw text.refusal("the file does not start with OFF, but with " + in_quotes(keyword),
                       "use the extension of its real format, or export it again");
  const auto next = [&] {
    const std::string_view token = text.token_anywhere();
    const auto count = parse_integer(token);
    if (!count || *count < 0)
      throw text.refusal("a count of vertices and faces was expected, not " + in_quotes(token),
                         "only OFF files of text with three coordinates can be read");
    return *count;
  };
  Counts counts;
  counts.vertices = next();
  counts.faces = next();
  return counts;
}

void require_line(TextLines& text, const char* element, std::int64_t i, std::int64_t count) {
  if (!text.next_line())
    throw text.refusal(
        "the file ends after " + std::to_string(i) + " of " + std::to_string(count) + " " + element,
        "it is incomplete: fetch or export it again");
}

}  // namespace

Triangles parse_off(std::string_view bytes, const std::string& file) {
  TextLines text(bytes, file, {.comment = '#'});
  const Counts counts = header(text);
  SurfaceBuilder builder(file);
  for (std::int64_t i = 0; i < counts.vertices; ++i) {
    require_line(text, "vertices", i, counts.vertices);
    const double x = text.number("x of a vertex"), y = text.number("y of a vertex");
    builder.add_position({x, y, text.number("z of a vertex")}, text.line());
  }
  std::vector<std::int64_t> face;
  for (std::int64_t i = 0; i < counts.faces; ++i) {
    require_line(text, "faces", i, counts.faces);
    const std::int64_t size = text.integer("the number of a face's vertices");
    face.clear();
    for (std::int64_t k = 0; k < size; ++k) face.push_back(text.integer("a vertex of a face"));
    builder.add_face(face, text.line());
  }
  if (text.next_line())
    throw text.refusal("there is more after the last face: " + in_quotes(text.token()),
                       "the counts at the top are wrong: export the mesh again");
  return std::move(builder).finish();
}

std::string format_off(const Triangles& surface) {
  std::string text = "OFF\n";
  append_integer(text, surface.positions.size());
  append_integer(text += ' ', surface.triangles.size());
  text += " 0\n";
  for (const Point& p : surface.positions) {
    append_number(text, p[0]);
    append_number(text += ' ', p[1]);
    append_number(text += ' ', p[2]);
    text += '\n';
  }
  for (const Triangle& t : surface.triangles) {
    text += '3';
    for (const std::uint32_t v : t) append_integer(text += ' ', v);
    text += '\n';
  }
  return text;
}

}  // namespace suture
