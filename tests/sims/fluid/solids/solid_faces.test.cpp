#include "sims/fluid/solids/solid_faces.h"

#include <catch2/catch.hpp>
#include <cmath>
#include <numbers>

using namespace suture;
using namespace suture::sims;

namespace {

SparseGrid cube_of_cells(int side, double h = 1, const Point& origin = Point::Zero()) {
  std::vector<Index3> cells;
  for (int x = 0; x < side; ++x)
    for (int y = 0; y < side; ++y)
      for (int z = 0; z < side; ++z) cells.push_back({x, y, z});
  return SparseGrid(origin, h, cells);
}

Solids only(const Solid& solid) { return {{solid}}; }

}  // namespace

TEST_CASE("a wall on a plane of the grid closes what is on it and nothing else, at any scale") {
  for (const double h : {1.0, 0.1, 1e-9, 3e7}) {
    const Point origin = h * Point(0.37, -100.1, 12);
    const SparseGrid grid = cube_of_cells(16, h, origin);
    const auto plane = [&](int i) -> Point { return origin + h * Point(i, i, i); };
    const SolidFaces faces = faces_of(only(Solid::container({plane(3), plane(12)})), grid, 0);
    int left_open = 0;
    for (Slot s = 0; s < grid.size(); ++s)
      for (int a = 0; a < 3; ++a) {
        const Index3 c = grid.cell(s);
        bool open = true;
        for (int b = 0; b < 3; ++b)
          open = open && (b == a ? c[b] > 3 && c[b] < 12 : c[b] >= 3 && c[b] < 12);
        left_open += open ? 1 : 0;
        if (std::abs(faces.open[a][s] - (open ? 1 : 0)) > 1e-12)
          FAIL("face " << a << " of cell " << c[0] << " " << c[1] << " " << c[2]);
      }
    CHECK(left_open == 3 * 8 * 9 * 9);
  }
}

TEST_CASE("a wall through cells leaves the part of a face that it does not cover") {
  const SparseGrid grid = cube_of_cells(8);
  const Solid wall = Solid::container({{-50, -50, -50}, {50, 50, 4.3}});
  const SolidFaces faces = faces_of(only(wall), grid, 0);
  CHECK(faces.open[0][grid.find({3, 3, 3})] == 1);
  CHECK(faces.open[0][grid.find({3, 3, 4})] == Approx(0.3));
  CHECK(faces.open[0][grid.find({3, 3, 5})] == 0);
  CHECK(faces.open[2][grid.find({3, 3, 4})] == 1);
  CHECK(faces.open[2][grid.find({3, 3, 5})] == 0);
}

TEST_CASE("the faces round a ball leave out its cross-section, to second order") {
  double before = 0;
  for (const double h : {0.25, 0.125}) {
    const SparseGrid grid = cube_of_cells(static_cast<int>(std::round(4 / h)), h);
    const SolidFaces faces = faces_of(only(Solid::ball({2.03, 1.96, 2.01}, 1.3)), grid, 0);
    // At the plane x = 2.
    double closed = 0;
    for (Slot s = 0; s < grid.size(); ++s)
      if (grid.cell(s)[0] == static_cast<int>(std::round(2 / h)))
        closed += (1 - faces.open[0][s]) * h * h;
    const double area = std::numbers::pi * (1.3 * 1.3 - 0.03 * 0.03);
    const double off = std::abs(closed / area - 1);
    CHECK(off < 0.2 * h * h);  // 0.0068 and 0.0018 measured
    if (before > 0) CHECK(off < before / 3);
    before = off;
  }
}

TEST_CASE("a diagonal wall halves the faces it crosses along their diagonals") {
  const SparseGrid grid = cube_of_cells(8);
  // A wedge with its upper side on the plane x + z = 8.
  Triangles wedge{
      {{0, -9, 8}, {8, -9, 0}, {0, -9, 0}, {0, 19, 8}, {8, 19, 0}, {0, 19, 0}},
      {{0, 2, 1}, {3, 4, 5}, {0, 1, 4}, {0, 4, 3}, {1, 2, 5}, {1, 5, 4}, {2, 0, 3}, {2, 3, 5}}};
  const SolidFaces faces = faces_of(only(Solid::mesh(wedge, {Point::Zero(), 1})), grid, 0);
  CHECK(faces.open[1][grid.find({3, 4, 4})] == Approx(0.5));
  CHECK(faces.open[1][grid.find({3, 4, 5})] == 1);
  CHECK(faces.open[1][grid.find({3, 4, 3})] == 0);
  CHECK(faces.open[0][grid.find({3, 4, 4})] == 0);
  CHECK(faces.open[0][grid.find({4, 4, 4})] == 1);
}

TEST_CASE("faces on a solid that moves know how fast, and no solid is no face") {
  SolidMotion motion;
  motion.velocity = Point(1, 0, 0);
  motion.amplitude = Point(0, 0.5, 0);
  motion.period = 2;
  const Solid bar = Solid::box({{2, 2, 2}, {5, 5, 5}}, motion);
  const SparseGrid grid = cube_of_cells(8);
  const SolidFaces faces = faces_of(only(bar), grid, 0);
  CHECK(faces.velocity[0][grid.find({5, 3, 3})] == Approx(1));
  CHECK(faces.velocity[1][grid.find({3, 5, 3})] == Approx(std::numbers::pi / 2));
  CHECK(faces.velocity[0][grid.find({7, 3, 3})] == 0);
  CHECK_FALSE(faces_of({}, grid, 0).any());
}
