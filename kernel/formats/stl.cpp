// STL, text or binary: loose triangles, whose exactly equal points are welded.
#include <cmath>
#include <limits>

#include "kernel/audit.h"
#include "kernel/errors.h"
#include "kernel/formats/builder.h"
#include "kernel/formats/bytes.h"
#include "kernel/formats/formats.h"
#include "kernel/formats/text.h"
#include "kernel/repair/weld.h"

namespace suture {

namespace {

constexpr std::size_t kHeader = 84, kFacet = 50;  // bytes of title and count, and of one facet

// The loose triangles with their equal points welded, vertices in the order of first use.
// Coordinates are checked before: a NaN would equal nothing.
Triangles welded(Triangles loose) {
  const std::vector<std::uint32_t> first = first_equal(loose.positions);
  Triangles surface;
  std::vector<std::uint32_t> renamed(first.size());
  for (std::size_t i = 0; i < first.size(); ++i) {
    if (first[i] == i) {
      renamed[i] = static_cast<std::uint32_t>(surface.positions.size());
      surface.positions.push_back(loose.positions[i]);
    } else {
      renamed[i] = renamed[first[i]];
    }
  }
  surface.triangles = std::move(loose.triangles);
  for (Triangle& t : surface.triangles)
    for (std::uint32_t& v : t) v = renamed[v];
  return surface;
}

void add_facet(SurfaceBuilder& builder, const std::array<Point, 3>& facet,
               const std::array<std::size_t, 3>& lines) {
  const auto v = static_cast<std::int64_t>(builder.positions());
  for (std::size_t k = 0; k < 3; ++k) builder.add_position(facet[k], lines[k]);
  builder.add_face(std::array{v, v + 1, v + 2}, lines[0]);
}

void expect(TextLines& text, std::string_view keyword) {
  const std::string_view token = text.token_anywhere();
  if (token == keyword) return;
  throw text.refusal(token.empty()
                         ? "the file ends where '" + std::string(keyword) + "' should stand"
                         : in_quotes(token) + " stands where '" + std::string(keyword) + "' should",
                     "it is incomplete or damaged: fetch or export it again");
}

double coordinate(TextLines& text) {
  const std::string_view token = text.token_anywhere();
  if (const auto x = parse_number(token)) return *x;
  throw text.refusal("a coordinate is missing or is not a number: " + in_quotes(token),
                     "the file is damaged; export it again");
}

Triangles parse_text(std::string_view bytes, const std::string& file) {
  TextLines text(bytes, file, {});
  SurfaceBuilder builder(file);
  while (text.next_line()) {
    if (text.token() != "solid")  // the rest of its line is a name
      throw text.refusal("there is more after 'endsolid'", "export the mesh again");
    bool open = true;
    while (open) {
      const std::string_view token = text.next_line() ? text.token() : std::string_view{};
      open = token == "facet";
      if (!open && token != "endsolid")
        throw text.refusal("a solid ends without 'endsolid'",
                           "the file is incomplete or damaged: fetch or export it again");
      if (!open) break;
      expect(text, "normal");
      for (int k = 0; k < 3; ++k)
        text.token_anywhere();  // normals are often wrong, and are never used
      expect(text, "outer");
      expect(text, "loop");
      std::array<Point, 3> facet;
      std::array<std::size_t, 3> lines{};
      for (std::size_t k = 0; k < 3; ++k) {
        expect(text, "vertex");
        lines[k] = text.line();
        for (double& x : facet[k]) x = coordinate(text);
      }
      expect(text, "endloop");
      expect(text, "endfacet");
      add_facet(builder, facet, lines);
    }
  }
  return welded(std::move(builder).finish());
}

Triangles parse_binary(std::string_view bytes, const std::string& file) {
  SurfaceBuilder builder(file);
  for (std::size_t at = kHeader; at < bytes.size(); at += kFacet) {
    std::array<Point, 3> facet;
    for (std::size_t k = 0; k < 3; ++k)
      for (int axis = 0; axis < 3; ++axis)
        facet[k][axis] = static_cast<double>(
            load<float>(bytes.data() + at + 12 + 12 * k + 4 * static_cast<std::size_t>(axis),
                        std::endian::little));
    add_facet(builder, facet, {});
  }
  return welded(std::move(builder).finish());
}

}  // namespace

Triangles parse_stl(std::string_view bytes, const std::string& file) {
  const std::size_t facets =
      bytes.size() < kHeader ? 0 : load<std::uint32_t>(bytes.data() + 80, std::endian::little);
  if (bytes.size() >= kHeader && bytes.size() == kHeader + kFacet * facets)
    return parse_binary(bytes, file);  // the size decides: many binary files start with "solid"
  TextLines probe(bytes, file, {});
  const bool text = bytes.find('\0') == std::string_view::npos;
  if (text && probe.next_line() && probe.token() == "solid") return parse_text(bytes, file);
  throw InvalidInput(file + ": neither text that starts with 'solid' nor binary STL: " +
                     std::to_string(bytes.size()) + " bytes where " + std::to_string(facets) +
                     " facets take " + std::to_string(kHeader + kFacet * facets) +
                     "; it is incomplete or damaged: fetch or export it again");
}

namespace {

/// The surface as a reader has it that rounds to floats, welds, and drops what has collapsed.
Triangles as_floats(Triangles surface) {
  for (Point& p : surface.positions)
    for (double& x : p)
      if (std::abs(x) <= std::numeric_limits<float>::max()) x = static_cast<float>(x);
  Triangles result = welded(std::move(surface));
  std::erase_if(result.triangles,
                [](const Triangle& t) { return t[0] == t[1] || t[1] == t[2] || t[2] == t[0]; });
  return result;
}

/// The first fault of a surface, or nothing.
std::string fault_of(const Triangles& surface) {
  const Audit result = audit(surface);
  return result.closed_manifold() ? "" : result.first;
}

}  // namespace

void require_apart_as_stl(const Triangles& surface, const std::string& name) {
  if (!fault_of(surface).empty()) return;
  std::string fault = fault_of(welded(surface));
  if (fault.empty()) fault = fault_of(as_floats(surface));
  if (fault.empty()) return;
  throw InvalidInput(name +
                     ": STL has no vertex indices, and readers that weld its points, some in 32 "
                     "bits, would find no closed manifold: " +
                     fault + "; nothing is written: write PLY, OBJ or OFF");
}

std::string format_stl(const Triangles& surface) {
  std::string text = "solid suture\n";
  for (const Triangle& t : surface.triangles) {
    text += "facet normal 0 0 0\nouter loop\n";
    for (const std::uint32_t v : t) {
      text += "vertex";
      for (const double x : surface.positions[v]) append_number(text += ' ', x);
      text += '\n';
    }
    text += "endloop\nendfacet\n";
  }
  return text + "endsolid suture\n";
}

}  // namespace suture
