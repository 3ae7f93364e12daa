// Components that are inside-out, however they are nested.
#include "kernel/repair/inside_out.h"

#include <catch2/catch.hpp>
#include <limits>

#include "kernel/errors.h"
#include "tests/kernel/tiny.h"

using namespace suture;

namespace {

using Found = std::vector<std::uint32_t>;

}  // namespace

TEST_CASE("the sign of a volume is exact where doubles see none") {
  // A needle of volume 2^-160 far from the origin.
  Triangles needle{{{1, 1, 1}, {1 + 0x1p-52, 1, 1}, {1, 1 + 0x1p-52, 1}, {1, 1, 1 + 0x1p-52}},
                   tetrahedron().triangles};
  CHECK(inside_out_components(needle).empty());
  CHECK(inside_out_components(turned(needle)) == Found{0});
  const Triangles flat{{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}}, tetrahedron().triangles};
  CHECK(inside_out_components(flat).empty());
  CHECK(inside_out_components(turned(flat)).empty());
}

TEST_CASE("cavities stay cavities, and bodies within bodies stay bodies") {
  const Triangles outer = cube(0, 9), middle = cube(1, 8), inner = cube(2, 7);
  CHECK(inside_out_components(joined(outer, turned(middle))).empty());
  CHECK(inside_out_components(joined(turned(middle), outer)).empty());
  CHECK(inside_out_components(joined(outer, middle)).empty());
  CHECK(inside_out_components(joined(joined(outer, turned(middle)), inner)).empty());
  CHECK(inside_out_components(joined(joined(outer, middle), turned(inner))).empty());
  // Material round nothing: a cavity of a cavity.
  CHECK(inside_out_components(joined(joined(outer, turned(middle)), turned(inner))) == Found{24});
}

TEST_CASE("bodies that overlap or lie apart do not hide that one is inside-out") {
  CHECK(inside_out_components(joined(cube(0, 2), turned(cube(1, 3)))) == Found{12});
  CHECK(inside_out_components(joined(turned(cube(1, 3)), cube(0, 2))) == Found{0});
  CHECK(inside_out_components(joined(cube(0, 1), turned(cube(5, 6)))) == Found{12});
  CHECK(inside_out_components(joined(turned(cube(0, 1)), turned(cube(5, 6)))) == Found{0, 12});
}
