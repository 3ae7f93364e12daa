#include "surgery/collapse/swept_nodes.h"

#include <CGAL/Kernel/global_functions_3.h>

#include <catch2/catch.hpp>

#include "kernel/mesh.h"
#include "tests/surgery/quality_bodies.h"

using namespace suture;
using namespace suture::surgery;
using namespace suture::bodies;

namespace {

/// A node that stands on integers, moved as the shift would move it; all coordinates are integers
/// below 100, so the steps are small enough to change no sign but those of ties.
bool holds_shifted(const std::array<Point, 4>& t, const Point& node) {
  const CgalPoint at(node[0] + 1e-4, node[1] + 1e-9, node[2] + 1e-14);
  const auto side = [&](int a, int b, int c) {
    return CGAL::orientation(to_cgal(t[static_cast<std::size_t>(a)]),
                             to_cgal(t[static_cast<std::size_t>(b)]),
                             to_cgal(t[static_cast<std::size_t>(c)]), at);
  };
  const auto s = side(0, 1, 2);
  return s == side(0, 2, 3) && s == side(0, 3, 1) && s == side(1, 3, 2);
}

}  // namespace

TEST_CASE("the node rule agrees with a lattice that is really shifted, ties included") {
  const auto filtered = make_filtered_oracle();
  const auto rational = make_rational_oracle();
  const Lattice lattice({{{-9, 0, 9}, {-9, 0, 9}, {-9, 0, 9}}});
  Dice dice(11);
  std::size_t held = 0;
  for (int i = 0; i < 20000; ++i) {
    std::array<Point, 4> t;
    for (Point& p : t)
      for (int a = 0; a < 3; ++a) p[a] = static_cast<double>(dice.below(5)) - 2;
    const bool expected =
        CGAL::orientation(to_cgal(t[0]), to_cgal(t[1]), to_cgal(t[2]), to_cgal(t[3])) != 0 &&
        holds_shifted(t, Point::Zero());
    REQUIRE(holds_node(t, {lattice, *filtered}) == expected);
    if (i % 20 == 0) REQUIRE(holds_node(t, {lattice, *rational}) == expected);
    held += expected;
  }
  CHECK(held > 500);
}

TEST_CASE("the node rule is the same at every scale, also where products of lengths vanish") {
  const auto oracle = make_filtered_oracle();
  for (const int power :
       {0, -360, -500, -515, -525, -530, -535, -540, -600, -1000, 345, 505, 508, 510, 900}) {
    Dice dice(13);
    std::size_t wrong = 0, held = 0;
    for (int i = 0; i < 2000; ++i) {
      std::array<Point, 4> t;
      for (Point& p : t)
        for (int a = 0; a < 3; ++a) p[a] = static_cast<double>(dice.below(41)) - 20;
      const auto answer = [&](int k) {
        std::vector<double> planes;
        for (int j = -5; j <= 5; ++j) planes.push_back(std::ldexp(5 * j, k));
        const double s = std::ldexp(1, k);
        const Lattice lattice({planes, planes, planes});
        return holds_node({t[0] * s, t[1] * s, t[2] * s, t[3] * s}, {lattice, *oracle});
      };
      const bool expected = answer(0);
      wrong += answer(power) != expected ? 1 : 0;
      held += expected ? 1 : 0;
    }
    CAPTURE(power);
    CHECK(wrong == 0);
    CHECK(held > 1000);
  }
}
