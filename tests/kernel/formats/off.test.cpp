// OFF files, good and faulty.
#include <catch2/catch.hpp>

#include "tests/kernel/formats/samples.h"
#include "tests/kernel/tiny.h"

using namespace suture;
using Catch::Matchers::Contains;

TEST_CASE("OFF: comments, colours, normals and polygons are read") {
  const TemporaryFolder folder;
  CHECK(same_bits(read_text(folder, "a.off", kOff), tetrahedron()));
  CHECK(same_bits(read_text(folder, "b.off", "# top\nOFF 4 4 6 # counts\n" + kOff.substr(10)),
                  tetrahedron()));
  const Triangles s =
      read_text(folder, "c.off",
                "CNOFF\n4 1 0\n0 0 0 0 0 1 255 0 0 255\n1 0 0 0 0 1 1 1 1 1\n"
                "1 1 0 0 0 1 1 1 1 1\n\n0 1 0 0 0 1 1 1 1 1\n4 0 1 2 3 0.5 0.5 0.5\n");
  CHECK(s.triangles.size() == 2);
  CHECK(s.positions[2] == Point(1, 1, 0));
}

TEST_CASE("OFF: faults are refused with their line") {
  const TemporaryFolder folder;
  const auto refused = [&](const std::string& text, const std::string& why) {
    INFO(text);
    CHECK_THROWS_WITH(read_text(folder, "a.off", text), Contains(why));
  };
  refused("4 4 6\n0 0 0\n", "does not start with OFF");
  refused("OFF BINARY\n", "a.off:1");
  refused("OFF\n-4 4 0\n", "'-4'");
  refused("OFF\n99999999999999 1 0\n0 0 0\n", "after 1 of 99999999999999 vertices");
  refused(kOff.substr(0, kOff.size() - 8), "after 3 of 4 faces");
  refused(kOff + "3 0 1 2\n", "a.off:11: there is more after the last face");
  refused("OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 -2\n", "a.off:6: face 0");
  refused("OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1\n", "a vertex of a face is missing");
  refused("OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n-3 0 1\n", "a.off:6");
}
