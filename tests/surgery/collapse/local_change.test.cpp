// Local changes, and that their corners and the kernel's can be used in one file.
#include "surgery/collapse/local_change.h"

#include <catch2/catch.hpp>

#include "kernel/corners.h"
#include "kernel/shapes/shapes.h"

using namespace suture;

TEST_CASE("the kernel's corners of a vertex and the corners of a local change live side by side") {
  const Triangles ball = sphere({.frequency = 2});
  const suture::Corners corners(ball);
  surgery::LocalChange change;
  Point sum = Point::Zero();
  for (const Corner& c : corners.of(0)) {
    const surgery::Corners before{ball.positions[0], ball.positions[c.next],
                                  ball.positions[c.prev]};
    change.triangles.push_back({before, before});
    sum += surgery::area_vector(before);
  }
  CHECK(change.triangles.size() == 5);
  CHECK(sum.dot(ball.positions[0]) > 0);
  CHECK(surgery::volume_moved(change) == 0);
}
