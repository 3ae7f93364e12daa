// Differences by volume, against bodies for which they are known.
#include "kernel/measure/symmetric_difference.h"

#include <catch2/catch.hpp>
#include <cmath>

#include "kernel/errors.h"
#include "kernel/measure/measures.h"
#include "kernel/shapes/shapes.h"
#include "kernel/shapes/transform.h"

using namespace suture;

TEST_CASE("a box and the same box moved differ by the two slabs between them") {
  const Triangles a = box({.edge_length = 0.5});
  for (const double shift : {0.3, 1e-3, 1e-7}) {
    const Triangles b = translated(a, {shift, 0, 0});
    const SymmetricDifference d = symmetric_difference(a, b, {.lines = 64});
    INFO(shift);
    CHECK(d.skipped == 0);
    CHECK(d.volume == Approx(2 * shift).epsilon(0.05));  // measured: within 3 %
    CHECK(d.error < 0.05 * d.volume);
  }
}

TEST_CASE("balls about one centre differ by the shell between them, however thin") {
  const Triangles a = sphere({.frequency = 20});
  for (const double factor : {1.1, 1.001, 1.000001}) {
    const Triangles b = scaled(a, factor);
    const double shell = volume(b) - volume(a);
    const SymmetricDifference d = symmetric_difference(a, b, {.lines = 100});
    INFO(factor);
    CHECK(d.skipped == 0);
    CHECK(d.volume == Approx(shell).epsilon(0.02));  // measured: within 0.4 %
    CHECK(std::abs(d.volume - shell) < 6 * d.error + 0.002 * shell);
  }
}

TEST_CASE("a surface does not differ from itself, and from nothing by its whole volume") {
  const Triangles a = zalesak({.edge_length = 2});
  CHECK(symmetric_difference(a, a).volume == 0);
  const SymmetricDifference d = symmetric_difference(a, {}, {.lines = 50});
  CHECK(d.volume == Approx(volume(a)).epsilon(0.01));
  CHECK(symmetric_difference({}, {}).volume == 0);
  CHECK_THROWS_AS(symmetric_difference(a, a, {.lines = 0}), InvalidInput);
}

TEST_CASE("what overlaps counts once, and what is turned inside out counts not at all") {
  const Triangles a = box({.edge_length = 1});
  const std::vector<Triangles> both = {a, translated(a, {0.5, 0, 0})};
  CHECK(symmetric_difference(merged(both), a, {.lines = 50}).volume == Approx(0.5).epsilon(0.03));
  Triangles inside_out = a;
  for (Triangle& t : inside_out.triangles) std::swap(t[0], t[1]);
  CHECK(symmetric_difference(inside_out, a, {.lines = 50}).volume == Approx(1).epsilon(0.03));
}
