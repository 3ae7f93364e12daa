#include "surgery/check/surgery_check.h"

#include <catch2/catch.hpp>

#include "kernel/shapes/shapes.h"
#include "kernel/shapes/transform.h"

using namespace suture;

namespace {

Triangles ball(double x, double radius) {
  return sphere({.centre = {x, 0.013, 0.021}, .radius = radius, .edge_length = 0.25});
}

Lattice lattice_round(const Triangles& surface) {
  return lattice_of(surface.positions, {.cell_size = 0.3, .origin = {0.007, 0.011, 0.019}});
}

/// Nodes of the lattice with this winding.
int nodes_with(int winding, const SurfaceCheck& check, const Lattice& lattice) {
  int count = 0;
  for (int i = 0; i < lattice.planes(0); ++i)
    for (int j = 0; j < lattice.planes(1); ++j)
      for (int k = 0; k < lattice.planes(2); ++k)
        count += check.winding({i, j, k}) == winding ? 1 : 0;
  return count;
}

}  // namespace

TEST_CASE("nodes in two balls have winding 2, those in one 1, and all three marches agree") {
  const Triangles surface = merged(std::vector{ball(0, 1), ball(0.8, 0.9)});
  const Lattice lattice = lattice_round(surface);
  const SurfaceCheck check(surface, lattice);
  CHECK(check.marches_agree());
  int both = 0, one = 0;
  for (int i = 0; i < lattice.planes(0); ++i)
    for (int j = 0; j < lattice.planes(1); ++j)
      for (int k = 0; k < lattice.planes(2); ++k) {
        const Point p = lattice.node({i, j, k});
        const double a = (p - Point(0, 0.013, 0.021)).norm() - 1,
                     b = (p - Point(0.8, 0.013, 0.021)).norm() - 0.9;
        if (std::min(std::abs(a), std::abs(b)) < 0.03) continue;  // between ball and polyhedron
        const int right = (a < 0 ? 1 : 0) + (b < 0 ? 1 : 0);
        both += right == 2 ? 1 : 0;
        one += right == 1 ? 1 : 0;
        for (int axis = 0; axis < 3; ++axis) CHECK(check.winding({i, j, k}, axis) == right);
      }
  CHECK(both > 20);
  CHECK(one > 50);
}

TEST_CASE("the nodes whose side differs are those that a moved ball gains and loses") {
  const Triangles before = ball(0, 1), after = ball(0.4, 1);
  const Lattice lattice = lattice_round(merged(std::vector{before, after}));
  const SurfaceCheck a(before, lattice), b(after, lattice);
  const std::vector<Index3> changed = SurfaceCheck::sides_changed(a, b);
  CHECK(changed.size() > 10);
  for (const Index3& node : changed) CHECK((a.winding(node) >= 1) != (b.winding(node) >= 1));
  const SurfaceCheck overlap(merged(std::vector{before, after}), lattice);
  CHECK(static_cast<int>(changed.size()) == nodes_with(1, overlap, lattice));
  CHECK(SurfaceCheck::sides_changed(a, a).empty());
}

TEST_CASE("a box on the lattice's planes has ties, and one off them has none") {
  const Triangles unit = box({.edge_length = 1});
  const TrackerOptions options{.cell_size = 0.5};
  const Lattice lattice = lattice_of(unit.positions, options);
  CHECK(count_ties(unit, lattice) > 0);
  const Triangles turned = translated(rotated(unit, {1, 2, 3}, 0.7), {0.013, 0.017, 0.023});
  CHECK(count_ties(turned, lattice_of(turned.positions, options)) == 0);
}
