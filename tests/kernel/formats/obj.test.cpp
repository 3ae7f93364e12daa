// OBJ files, good and faulty.
#include <catch2/catch.hpp>

#include "kernel/errors.h"
#include "tests/kernel/formats/samples.h"

using namespace suture;
using Catch::Matchers::Contains;

TEST_CASE("OBJ: slashes, negative indices, polygons, groups, joined lines and CRLF are read") {
  const TemporaryFolder folder;
  const Triangles s = read_text(folder, "a.obj",
                                "# cube\r\nmtllib x.mtl\r\no thing\r\nv 0 0 0\r\nv 1 0 0 1.0\r\n"
                                "v 1 1 0 0.5 0.5 0.5\r\nv 0 1 0\r\nvt 0 0\r\nvn 0 0 1\r\ns off\r\n"
                                "g all\r\nf 1/1/1 2//1 3/1 \\\r\n 4\r\nf -4 -3 -1 # last\r\n");
  CHECK(s.positions.size() == 4);
  CHECK(s.triangles == std::vector<Triangle>{{0, 1, 2}, {0, 2, 3}, {0, 1, 3}});
}

TEST_CASE("OBJ: faults are refused with their line") {
  const TemporaryFolder folder;
  const auto refused = [&](const std::string& text, const std::string& why) {
    INFO(text);
    CHECK_THROWS_WITH(read_text(folder, "a.obj", text), Contains(why));
    CHECK_THROWS_AS(read_text(folder, "a.obj", text), InvalidInput);
  };
  refused("v 0 0 0\nv 1 x 0\n", "a.obj:2: y of a vertex is not a number: 'x'");
  refused("v 0 0 0\nv 1\n", "a.obj:2: y of a vertex is missing");
  refused("v 0 0 0\nv 1 0 0\nv 0 nan 0\nv inf 0 0\nf 1 2 3\n", "a.obj:3: vertex 3");
  refused("v 0 0 0\nv 1 0 0\nv 0 1e999 0\nf 1 2 3\n", "not finite (1 such");
  refused("v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\nf 1 2 4\nf 7 8 9\n",
          "a.obj:5: face 2 has the vertex index 4, counted from 1,");
  refused("v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\nf 1 2 4\nf 7 8 9\n", "4 such in all");
  refused("v 0 0 0\nv 1 0 0\nv 0 1 0\nf -1 -2 -4\n", "a.obj:4: a face has the vertex index -4");
  refused("v 0 0 0\nv 1 0 0\nv 0 1 0\nf 0 1 2\n", "a.obj:4");
  refused("v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2\n", "a.obj:4: face 1 has 2 vertices");
  refused("v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3.5\n", "'3.5'");
  refused("v 0 0 0\nv 1 0 0\nv 0 1 0\nf 99999999999999999999 1 2\n", "a.obj:4");
  refused(kObj + "hello\n", "a.obj:9: 'hello' is not a keyword");
}
