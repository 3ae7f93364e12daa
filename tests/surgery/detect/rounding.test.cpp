#include "surgery/detect/rounding.h"

#include <catch2/catch.hpp>

#include "kernel/shapes/shapes.h"

using namespace suture;
using namespace suture::surgery;

TEST_CASE("rounding reaches no node a cell away from the surface where cells are sixteen units") {
  constexpr double kCell = 0x1p-48;
  Triangles cube = box({{0, 0, 0}, {1, 1, 1}, 0.25});
  for (Point& p : cube.positions) p = Point::Constant(1) + 0x1p-44 * p;  // sixteen cells long
  const Lattice lattice =
      lattice_around(bounding_box(cube.positions), kCell, Point::Constant(1), 4);
  const Rounding rounding(cube, lattice);
  const Point corner = Point::Constant(1) + kCell * Point(0, 0, -8);  // in the middle of a face
  Index3 node{};
  for (int a = 0; a < 3; ++a)
    while (lattice.plane(a, node[a]) < corner[a]) ++node[a];
  CHECK(rounding.reaches(node));
  CHECK_FALSE(rounding.reaches({node[0], node[1], node[2] + 1}));
  CHECK_FALSE(rounding.reaches({node[0], node[1], node[2] - 1}));
}
