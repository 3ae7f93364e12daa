// The filtered oracle against its rational twin, where signs are close to call.
#include <catch2/catch.hpp>
#include <thread>

#include "tests/brute/sign_questions.h"

using namespace suture;
using namespace suture::brute;

namespace {

// Twelve families times three predicates times these: 1,080,000 decisions.
constexpr int kCasesAFamily = 30'000;

/// The first question that the filtered oracle and its rational twin disagree about, or empty.
std::string disagreement(Decision decision, Family family) {
  Draws random(static_cast<std::uint64_t>(family) + 1);
  const auto filtered = make_filtered_oracle(), rational = make_rational_oracle();
  for (int i = 0; i < kCasesAFamily; ++i) {
    const SignQuestion question = sign_question(decision, family, random);
    const int sign = ask(*filtered, question), right = ask(*rational, question);
    if (sign != right)
      return std::to_string(sign) + " is not " + std::to_string(right) + ": " + show(question);
  }
  return "";
}

/// The first case for which `holds` does not, on the filtered oracle; empty if there is none.
template <class Property>
std::string exception_to(Family family, const Property& holds) {
  Draws random(static_cast<std::uint64_t>(family) + 101);
  const auto oracle = make_filtered_oracle();
  for (int i = 0; i < kCasesAFamily; ++i) {
    const Points4 points = near_degenerate(family, random);
    if (!holds(*oracle, points, random)) return show(points);
  }
  return "";
}

}  // namespace

TEST_CASE("both oracles see a lattice line on the same side of an edge", "[slow]") {
  for (Family family : kFamilies) {
    INFO(family);
    CHECK(disagreement(Decision::edge_side, family) == "");
  }
}

TEST_CASE("both oracles see a lattice node on the same side of a triangle", "[slow]") {
  for (Family family : kFamilies) {
    INFO(family);
    CHECK(disagreement(Decision::triangle_side, family) == "");
  }
}

TEST_CASE("both oracles give four points the same orientation", "[slow]") {
  for (Family family : kFamilies) {
    INFO(family);
    CHECK(disagreement(Decision::orientation, family) == "");
  }
}

TEST_CASE("turning an edge or the axes round turns the side round") {
  for (Family family : kFamilies) {
    INFO(family);
    CHECK(exception_to(family, [](const Oracle& oracle, const Points4& p, Draws& random) {
            const LatticePoint2 at = lattice_point(p[2], random);
            const int side = oracle.edge_side(p[0], p[1], at);
            return side == -oracle.edge_side(p[1], p[0], at) &&
                   side == -oracle.edge_side(p[0], p[1], {at.v_axis, at.u_axis, at.v, at.u});
          }) == "");
  }
}

TEST_CASE("a triangle's side follows the order of its corners", "[slow]") {
  for (Family family : kFamilies) {
    INFO(family);
    CHECK(exception_to(family, [](const Oracle& oracle, const Points4& p, Draws&) {
            const int side = oracle.triangle_side(p[0], p[1], p[2], p[3]);
            return side == oracle.triangle_side(p[1], p[2], p[0], p[3]) &&
                   side == -oracle.triangle_side(p[1], p[0], p[2], p[3]) &&
                   side == -oracle.triangle_side(p[0], p[2], p[1], p[3]);
          }) == "");
  }
}

TEST_CASE("orientation changes sign with every swap of its points", "[slow]") {
  for (Family family : kFamilies) {
    INFO(family);
    CHECK(exception_to(family, [](const Oracle& oracle, const Points4& p, Draws&) {
            const int sign = oracle.orientation(p[0], p[1], p[2], p[3]);
            return sign == -oracle.orientation(p[1], p[0], p[2], p[3]) &&
                   sign == -oracle.orientation(p[0], p[1], p[3], p[2]) &&
                   sign == -oracle.orientation(p[3], p[1], p[2], p[0]);
          }) == "");
  }
}

TEST_CASE("an edge has no side only where it projects to a point") {
  for (Family family : kFamilies) {
    INFO(family);
    CHECK(exception_to(family, [](const Oracle& oracle, const Points4& p, Draws& random) {
            const LatticePoint2 at = lattice_point(p[2], random);
            const bool point =
                p[0][at.u_axis] == p[1][at.u_axis] && p[0][at.v_axis] == p[1][at.v_axis];
            return (oracle.edge_side(p[0], p[1], at) == 0) == point;
          }) == "");
  }
}

TEST_CASE("the filter decides all random input and admits where it cannot") {
  Draws random(7);
  const auto oracle = make_filtered_oracle();
  {
    const OracleTally tally;
    for (int i = 0; i < 10'000; ++i) {
      const Points4 p = near_degenerate(Family::random, random);
      oracle->triangle_side(p[0], p[1], p[2], p[3]);
      oracle->edge_side(p[0], p[1], lattice_point(p[2], random));
    }
    CHECK(tally.counts().triangle_side == 10'000);
    CHECK(tally.counts().edge_side == 10'000);
    CHECK(tally.counts().filter_failures == 0);
  }
  const OracleTally tally;
  oracle->orientation({0, 0, 0}, {3, 1, 1}, {1, 3, 1}, {4, 4, 2});
  CHECK(tally.counts().orientation == 1);
  CHECK(tally.counts().filter_failures == 1);
}

TEST_CASE("of nested tallies the innermost counts, and a thread's own only") {
  const auto oracle = make_rounded_oracle();
  const auto ask = [&] { oracle->orientation({0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}); };
  const OracleTally outer;
  ask();
  {
    const OracleTally inner;
    ask();
    ask();
    OracleCounts elsewhere;
    std::thread([&] {
      const OracleTally other;
      for (int i = 0; i < 7; ++i) ask();
      elsewhere = other.counts();
    }).join();
    CHECK(elsewhere.orientation == 7);
    CHECK(inner.counts().orientation == 2);
  }
  CHECK(outer.counts().orientation == 1);
}

TEST_CASE("threads that share an oracle get the answers and the counts of one alone") {
  for (const Arithmetic arithmetic :
       {Arithmetic::rounded, Arithmetic::filtered, Arithmetic::rational}) {
    const auto oracle = make_oracle(arithmetic);
    const auto answers = [&](std::uint64_t seed) {
      Draws random(seed);
      const OracleTally tally;
      std::vector<std::uint64_t> all;
      for (int i = 0; i < 3000; ++i) {
        const Points4 p = near_degenerate(kFamilies[i % std::size(kFamilies)], random);
        const LatticePoint2 at = lattice_point(p[2], random);
        all.push_back(static_cast<std::uint64_t>(9 * oracle->edge_side(p[0], p[1], at) +
                                                 3 * oracle->orientation(p[0], p[1], p[2], p[3]) +
                                                 oracle->triangle_side(p[0], p[1], p[2], p[3]) +
                                                 13));
      }
      all.push_back(tally.counts().edge_side);
      all.push_back(tally.counts().filter_failures);
      return all;
    };
    const auto one = answers(1), two = answers(2);
    std::vector<std::uint64_t> there;
    std::thread thread([&] { there = answers(2); });
    const std::vector<std::uint64_t> here = answers(1);
    thread.join();
    CHECK(here == one);
    CHECK(there == two);
    CHECK(one != two);
  }
}
