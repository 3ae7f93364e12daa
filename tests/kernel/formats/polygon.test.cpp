// Polygons cut into triangles.
#include <catch2/catch.hpp>

#include "kernel/measure/measures.h"
#include "tests/kernel/formats/samples.h"

using namespace suture;

TEST_CASE("concave polygons are triangulated without folds") {
  const TemporaryFolder folder;
  // An L seen from above and from below, in each of its six rotations, and on its side.
  const double at[6][2] = {{0, 0}, {2, 0}, {2, 1}, {1, 1}, {1, 2}, {0, 2}};
  for (int start = 0; start < 6; ++start)
    for (const bool up : {true, false}) {
      std::string text;
      for (const auto& p : at)
        text += "v " + std::to_string(p[0]) + " 0 " + std::to_string(p[1]) + "\n";
      text += "f";
      for (int i = 0; i < 6; ++i) text += " " + std::to_string((start + (up ? i : 6 - i)) % 6 + 1);
      const Triangles s = read_text(folder, "l.obj", text + "\n");
      CHECK(s.triangles.size() == 4);
      CHECK(area(s) == 3);  // a fold would count twice
    }
}
