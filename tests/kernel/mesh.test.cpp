#include "kernel/mesh.h"

#include <catch2/catch.hpp>

using namespace suture;

TEST_CASE("a tetrahedron goes to a Surface_mesh and back unchanged") {
  const Triangles tetrahedron{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}},
                              {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {0, 3, 2}}};
  CHECK(to_triangles(to_mesh(tetrahedron)) == tetrahedron);
}
