// STL files, good and faulty, as text and binary.
#include <catch2/catch.hpp>

#include "kernel/audit.h"
#include "kernel/formats/formats.h"
#include "kernel/measure/measures.h"
#include "tests/kernel/formats/samples.h"
#include "tests/kernel/tiny.h"

using namespace suture;
using Catch::Matchers::Contains;

TEST_CASE("STL: binary is told from text by its size, and points are welded") {
  const TemporaryFolder folder;
  std::string bytes = "solid yet binary";
  bytes.resize(80, ' ');
  const Triangles s = tetrahedron();
  const auto put = [&](auto x) { bytes.append(reinterpret_cast<const char*>(&x), sizeof x); };
  put(std::uint32_t{4});
  for (const Triangle& t : s.triangles) {
    for (int i = 0; i < 3; ++i) put(0.0F);
    for (const std::uint32_t v : t)
      for (const double x : s.positions[v]) put(static_cast<float>(x));
    put(std::uint16_t{7});
  }
  const Triangles back = read_text(folder, "a.stl", bytes);
  CHECK(back.positions.size() == 4);
  CHECK(audit(back).closed_manifold());
  CHECK(volume(back) == volume(s));
  CHECK_THROWS_WITH(read_text(folder, "a.stl", bytes.substr(0, 200)),
                    Contains("200 bytes where 4 facets take 284"));
}

TEST_CASE("STL: degenerate facets are kept for the audit to report") {
  const TemporaryFolder folder;
  Triangles s = tetrahedron();
  s.triangles.push_back({1, 1, 2});
  write_triangles(folder / "a.stl", s);
  CHECK(audit(read_triangles(folder / "a.stl")).degenerate_triangles == 1);
}

TEST_CASE("STL: faults in text are refused with their line") {
  const TemporaryFolder folder;
  const auto refused = [&](const std::string& text, const std::string& why) {
    INFO(text);
    CHECK_THROWS_WITH(read_text(folder, "a.stl", text), Contains(why));
  };
  const std::string text = format_stl(tetrahedron());
  refused("facet\n", "neither text that starts with 'solid'");
  refused("solid a\nfacet normal 0 0 1\nouter loop\nvertex 0 0 zero\n", "a.stl:4");
  refused("solid a\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nendloop\n",
          "'endloop' stands where 'vertex' should");
  refused(text.substr(0, text.size() - 16), "without 'endsolid'");
  refused(text + "more\n", "more after 'endsolid'");
  refused("solid\nendsolid\n", "the mesh is empty");
}
