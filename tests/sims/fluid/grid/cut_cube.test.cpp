#include "sims/fluid/grid/cut_cube.h"

#include <catch2/catch.hpp>
#include <cmath>

#include "kernel/random.h"

using namespace suture;
using namespace suture::sims;

namespace {

/// The part of the cube below the plane, counted.
CutCube counted(const Point& normal, double s) {
  constexpr int n = 60;
  CutCube cut;
  for (int i = 0; i < n; ++i)
    for (int j = 0; j < n; ++j)
      for (int k = 0; k < n; ++k) {
        const double t = normal.dot(Point(i + 0.5, j + 0.5, k + 0.5) / n - Point::Constant(0.5));
        if (t >= s) continue;
        cut.volume += 1;
        cut.offset += t;
      }
  cut.offset /= cut.volume;
  cut.volume /= n * n * n;
  return cut;
}

}  // namespace

TEST_CASE("the part of a cube below a plane is right however the plane lies") {
  Random random(11);
  for (int i = 0; i < 40; ++i) {
    Point normal{random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(-1, 1)};
    normal.normalize();
    const double s = random.uniform(-0.4, 0.4);
    const CutCube cut = cut_cube(normal, s), count = counted(normal, s);
    CAPTURE(normal.transpose(), s);
    CHECK(cut.volume == Approx(count.volume).margin(3e-3));  // what the counting is off by
    CHECK(cut.offset == Approx(count.offset).margin(3e-3));
    CHECK(cut.volume + cut_cube(-normal, -s).volume == Approx(1).epsilon(1e-14));
  }
  CHECK(cut_cube({0, 0, 1}, 0.3).volume == Approx(0.8).epsilon(1e-15));
  CHECK(cut_cube({0, 0, 1}, 0.3).offset == Approx(-0.1).epsilon(1e-4));
  const Point corner = Point::Constant(1 / std::sqrt(3.0));
  CHECK(cut_cube(corner, -std::sqrt(3.0) / 3).volume == Approx(1.0 / 48).epsilon(1e-12));
  CHECK(cut_cube(corner, 0).volume == Approx(0.5).epsilon(1e-14));
  CHECK(cut_cube(corner, 1).volume == 1);
  CHECK(cut_cube(corner, -1).volume == 0);
}

TEST_CASE("the part of a cube is continuous where the plane is all but square to it") {
  for (const double tilt : {1e-3, 1e-6, 1e-9, 1e-13, 1e-160})
    for (const double s : {-0.49, -0.2, 0.0, 0.31}) {
      const Point one = Point(tilt, 1, 0).normalized(),
                  two = Point(tilt, 0.3 * tilt, 1).normalized();
      CAPTURE(tilt, s);
      CHECK(cut_cube(one, s).volume == Approx(0.5 + s).margin(2 * tilt * tilt + 1e-14));
      CHECK(cut_cube(two, s).volume == Approx(0.5 + s).margin(2 * tilt * tilt + 1e-14));
    }
}
