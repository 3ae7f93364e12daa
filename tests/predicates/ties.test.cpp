// Ties: what they must be by hand, that they agree with one another, and that wrong ones show.
#include <catch2/catch.hpp>
#include <map>

#include "kernel/lattice.h"
#include "predicates/oracle.h"
#include "tests/brute/broken_oracles.h"
#include "tests/brute/near_degenerate.h"

using namespace suture;
using namespace suture::brute;

namespace {

constexpr std::array kArithmetics = {Arithmetic::filtered, Arithmetic::rational};

using Tetrahedron = Points4;
constexpr std::array<std::array<int, 3>, 4> kFaces = {{{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {0, 3, 2}}};

/// The way in which the ray from the shifted node along `axis` crosses triangle abc, +1 out of it;
/// 0 if it does not.
int crossing(const Oracle& oracle, const std::array<Point, 3>& t, int axis, const Point& node) {
  const int u = next_axis(axis), v = prev_axis(axis);
  const LatticePoint2 line{u, v, node[u], node[v]};
  const int side = oracle.edge_side(t[0], t[1], line);
  if (side == 0 || oracle.edge_side(t[1], t[2], line) != side ||
      oracle.edge_side(t[2], t[0], line) != side)
    return 0;
  return oracle.triangle_side(t[0], t[1], t[2], node) == -side ? side : 0;
}

int winding(const Oracle& oracle, const Tetrahedron& body, int axis, const Point& node) {
  int sum = 0;
  for (const auto& f : kFaces)
    sum += crossing(oracle, {body[f[0]], body[f[1]], body[f[2]]}, axis, node);
  return sum;
}

/// The number of `cases` tetrahedra of small integers that have an integer node that rays along the
/// three axes do not agree about, or that winds by more than one.
int inconsistent(const Oracle& oracle, int cases) {
  Draws random(11);
  int count = 0;
  for (int i = 0; i < cases; ++i) {
    const Tetrahedron body = near_degenerate(Family::small_integers, random);
    const Point node{double(random.below(4)), double(random.below(4)), double(random.below(4))};
    const int x = winding(oracle, body, 0, node);
    count += x != winding(oracle, body, 1, node) || x != winding(oracle, body, 2, node) ||
             std::abs(x) > 1;
  }
  return count;
}

/// The number of `cases` questions that the two answer differently, by the family of the points.
std::map<Family, int> differences(const Oracle& one, const Oracle& other, int cases) {
  std::map<Family, int> count;
  for (Family family : kFamilies) {
    Draws random(13);
    for (int i = 0; i < cases; ++i) {
      const Points4 p = near_degenerate(family, random);
      const int u = random.below(3), v = (u + random.between(1, 2)) % 3;
      const LatticePoint2 at{u, v, p[2][u], p[2][v]};
      count[family] +=
          one.edge_side(p[0], p[1], at) != other.edge_side(p[0], p[1], at) ||
          one.triangle_side(p[0], p[1], p[2], p[3]) != other.triangle_side(p[0], p[1], p[2], p[3]);
    }
  }
  return count;
}

int total(const std::map<Family, int>& counts) {
  int sum = 0;
  for (const auto& [family, count] : counts) sum += count;
  return sum;
}

}  // namespace

TEST_CASE("a lattice line on an edge moves off it by its lower axis first") {
  for (Arithmetic arithmetic : kArithmetics) {
    const auto oracle = make_oracle(arithmetic);
    const auto side = [&](const Point& q, const LatticePoint2& at) {
      return oracle->edge_side({0, 0, 0}, q, at);
    };
    CHECK(side({0, 2, 0}, {0, 1, 0, 1}) == -1);  // the edge is upright: shifted in x, to its right
    CHECK(side({2, 0, 0}, {0, 1, 1, 0}) == 1);   // it lies along x: shifted in y, to its left
    CHECK(side({2, 2, 0}, {0, 1, 1, 1}) == -1);  // both count: x counts more
    CHECK(side({2, 2, 0}, {1, 0, 1, 1}) == 1);   // the same, seen from below
    CHECK(side({0, 2, 2}, {1, 2, 1, 1}) == -1);  // y counts more than z
    CHECK(side({2, 0, 2}, {2, 0, 1, 1}) == 1);   // x counts more than z
    CHECK(side({2, 0, 2}, {0, 2, 0, 0}) == -1);  // at an end of the edge too
    CHECK(side({0, 0, 2}, {0, 1, 0, 0}) == 0);   // seen end-on it has no sides
    CHECK(side({0, 0, 2}, {0, 1, 5, -7}) == 0);
  }
}

TEST_CASE("a node on a triangle's plane moves off it by the normal's first component") {
  for (Arithmetic arithmetic : kArithmetics) {
    const auto oracle = make_oracle(arithmetic);
    const Point o(0, 0, 0), x(1, 0, 0), y(0, 1, 0), z(0, 0, 1);
    CHECK(oracle->triangle_side(o, x, y, o) == 1);
    CHECK(oracle->triangle_side(o, y, x, o) == -1);
    CHECK(oracle->triangle_side(o, y, z, {0, 5, 5}) == 1);
    CHECK(oracle->triangle_side(o, z, x, {5, 0, 5}) == 1);
    CHECK(oracle->triangle_side(x, y, z, x) == 1);
    CHECK(oracle->triangle_side(o, Point(1, 0, 1), y, o) == -1);  // normal (−1, 0, 1): x decides
    CHECK(oracle->triangle_side(o, x, Point(0, 1, 1), o) == -1);  // normal (0, −1, 1): y decides
    CHECK(oracle->triangle_side(o, x, Point(2, 0, 0), o) == 0);   // no area, no sides
    CHECK(oracle->triangle_side(o, x, Point(2, 0, 0), {0, 3, 4}) == 0);
  }
}

TEST_CASE("orientation is positive where the normal points, and is not shifted") {
  for (Arithmetic arithmetic : kArithmetics) {
    const auto oracle = make_oracle(arithmetic);
    CHECK(oracle->orientation({0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}) == 1);
    CHECK(oracle->orientation({0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {9, 9, -1}) == -1);
    CHECK(oracle->orientation({0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {9, 9, 0}) == 0);
  }
}

TEST_CASE("an axis-parallel edge on a lattice line keeps to the cells of its coordinates") {
  // cell_of puts a coordinate that equals a plane below it; the oracle must say the same.
  const Lattice lattice({{{0, 1, 2}, {0, 1, 2}, {0, 1, 2}}});
  for (Arithmetic arithmetic : kArithmetics) {
    const auto oracle = make_oracle(arithmetic);
    for (int along = 0; along < 3; ++along)
      for (int across : {next_axis(along), prev_axis(along)}) {
        Point p = Point::Constant(1), q = p;
        q[along] = 2;
        REQUIRE(lattice.cell_of(across, p[across]) == 0);
        // Seen with `along` to the right, the plane across is on the left: above the edge.
        CHECK(oracle->edge_side(p, q, {along, across, 1.5, 1}) == 1);
      }
  }
}

TEST_CASE("rays along the three axes agree on tetrahedra and nodes of small integers", "[slow]") {
  CHECK(inconsistent(*make_filtered_oracle(), 30'000) == 0);
  CHECK(inconsistent(*make_rational_oracle(), 3'000) == 0);
}

TEST_CASE("breaking ties by the order in which axes are named makes those rays disagree") {
  CHECK(inconsistent(NamedOrder(), 3'000) > 0);
}

TEST_CASE("any other order of the shifts, or shifts downwards, differ from the rational oracle") {
  const auto rational = make_rational_oracle();
  const std::array<std::array<int, 3>, 5> orders = {
      {{0, 2, 1}, {1, 0, 2}, {1, 2, 0}, {2, 0, 1}, {2, 1, 0}}};
  for (const auto& order : orders) {
    INFO(order[0] << order[1] << order[2]);
    CHECK(differences(WrongShift(order, 1), *rational, 500)[Family::small_integers] > 0);
  }
  CHECK(differences(WrongShift({0, 1, 2}, -1), *rational, 500)[Family::small_integers] > 0);
  CHECK(differences(NamedOrder(), *rational, 500)[Family::small_integers] > 0);
  CHECK(total(differences(WrongShift({0, 1, 2}, 1), *rational, 500)) == 0);
}

TEST_CASE("a filter with too small a bound differs from the rational oracle") {
  const auto rational = make_rational_oracle();
  const double u = 0x1p-53, least = 1e-290;
  CHECK(total(differences(WeakFilter({0, least, least}), *rational, 2'000)) > 0);
  CHECK(total(differences(WeakFilter({u, least, least}), *rational, 6'000)) > 0);
  CHECK(differences(WeakFilter({9 * u, 0, 0}), *rational, 2'000)[Family::stretched] > 0);
  CHECK(differences(WeakFilter({9 * u, least, 0}), *rational, 2'000)[Family::stretched] > 0);
  CHECK(total(differences(WeakFilter({9 * u, least, least}), *rational, 2'000)) == 0);
}
