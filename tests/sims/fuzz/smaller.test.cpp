#include <catch2/catch.hpp>

#include "kernel/audit.h"
#include "kernel/measure/measures.h"
#include "sims/fuzz/case_maker.h"
#include "sims/fuzz/smaller.h"

using namespace suture;
using namespace suture::sims;

TEST_CASE("a component is left out, or gives way to a tetrahedron or a box of the same sign") {
  const FuzzCase c = make_case(3, {Profile::random});
  const Triangles two = c.surface;
  const std::size_t count = components(two).count;
  CHECK(components(without_component(two, 0)).count == count - 1);
  for (const Stand stand : {Stand::tetrahedron, Stand::box}) {
    const Triangles other = component_replaced(two, 0, stand);
    REQUIRE_FALSE(other.triangles.empty());
    CHECK(audit(other).closed_manifold());
    CHECK(components(other).count == count);
    CHECK(other.triangles.size() < two.triangles.size());
  }
}

TEST_CASE("edges collapse until a tetrahedron is left, closed and manifold throughout") {
  Triangles surface = make_case(7, {Profile::random}).surface;
  for (std::size_t t = 0; t < surface.triangles.size();)
    t = collapse_edge(surface, t, 0) ? 0 : t + 1;
  CHECK(audit(surface).closed_manifold());
  CHECK(surface.triangles.size() >= 4 * components(surface).count);
  CHECK(surface.triangles.size() <= 40 * components(surface).count);
}

TEST_CASE("numbers are rounded to so many bits") {
  CHECK(rounded_to_bits(0.3, 1) == 0.25);
  CHECK(rounded_to_bits(-5.3, 3) == -5);
  CHECK(rounded_to_bits(0, 3) == 0);
  CHECK(rounded_to_bits(0x1p-1074, 4) == 0x1p-1074);
  CHECK(rounded_to_bits(0.1, 53) == 0.1);
}
