// The same bits from every compiler and build: digests of whole surfaces, position by position.
//
// A new row: add the case, run the test, and paste the line that it prints. A digest that changes
// where results were not meant to change is a fault; one that two compilers disagree about is too.
#include <catch2/catch.hpp>

#include <algorithm>
#include <bit>
#include <cstdio>
#include <map>
#include <string>

#include "kernel/hash.h"
#include "kernel/shapes/catalogue.h"
#include "sims/flows/fields.h"
#include "surgery/model/option_table.h"
#include "tests/surgery/golden_digests.h"
#include "tests/surgery/hostile.h"
#include "tests/surgery/support.h"

using namespace suture;
using namespace suture::surgery;
using namespace suture::sims;

namespace {

/// FNV-1a over the bits of all coordinates and indices, in order.
std::uint64_t digest(const Triangles& surface) {
  std::uint64_t hash = kFnvStart;
  const auto add = [&](std::uint64_t word) { hash = fnv1a(word, hash); };
  for (const Point& p : surface.positions)
    for (const double x : p) add(std::bit_cast<std::uint64_t>(x));
  for (const Triangle& t : surface.triangles)
    for (const std::uint32_t v : t) add(v);
  return hash;
}

/// As golden_digests.h has it.
std::string golden_line(const std::string& name, std::uint64_t digest) {
  char hex[24];
  std::snprintf(hex, sizeof hex, "0x%016llxULL", static_cast<unsigned long long>(digest));
  return "{\"" + name + "\", " + hex + "},";
}

void check(const std::string& name, const Triangles& surface) {
  const auto row = std::find_if(std::begin(kGolden), std::end(kGolden),
                                [&](const Golden& g) { return g.name == name; });
  const std::string line = golden_line(name, digest(surface));
  if (row == std::end(kGolden))
    FAIL_CHECK("a case without a row: " << line);
  else
    CHECK_THAT(line, Catch::Equals(golden_line(name, row->digest)));
}

/// Two balls that overlap, a box on the lattice beside them, and a thread to be split.
Triangles mixed_bodies() {
  return merged(std::vector<Triangles>{ball(1, {0.013, 0.017, 0.011}, 6),
                                       ball(0.8, {1.113, 0.207, 0.109}, 6),
                                       box({Point(-1.5, 0, 0), Point(1, 0.5, 1), 0.5}),
                                       cylinder({Point(0.6, 0.4, 1.6), 0.03, 1.5, 0.2})});
}

Triangles remodelled_twice(const Triangles& surface, const TrackerOptions& options) {
  Tracker tracker(surface, options);
  tracker.remodel();
  tracker.improve();
  tracker.remodel();
  return tracker.surface();
}

}  // namespace

TEST_CASE("every collapse, placement and arithmetic gives the same bits everywhere") {
  for (const auto& collapse : kCollapseNames)
    for (const auto& placement : kPlacementNames)
      for (const auto& arithmetic : kArithmeticNames)
        check(std::string(collapse.name) + " " + placement.name + " " + arithmetic.name,
              remodelled_twice(mixed_bodies(), {.cell_size = 0.25,
                                                .collapse = collapse.value,
                                                .placement = placement.value,
                                                .arithmetic = arithmetic.value}));
}

TEST_CASE("every choice of events, cells and subdivision gives the same bits everywhere") {
  for (const auto& events : kEventsNames)
    for (const auto& test : kCellTestNames)
      check(std::string("events ") + events.name + " " + test.name,
            remodelled_twice(
                mixed_bodies(),
                {.cell_size = 0.25, .events = events.value, .cell_test = test.value, .depth = 0}));
  for (const auto& subdivision : kSubdivisionNames) {
    TrackerOptions options{.cell_size = 0.25};
    options.quality.edge_length = 0.1;
    options.quality.subdivision = subdivision.value;
    check(std::string("subdivision ") + subdivision.name,
          remodelled_twice(mixed_bodies(), options));
  }
  TrackerOptions options{.cell_size = 0.25};
  options.quality.keep_features = false;
  options.quality.subdivision = Subdivision::fitted;
  options.quality.chord_error = 0.01;
  check("edges by curvature", remodelled_twice(mixed_bodies(), options));
}

TEST_CASE("hostile input gives the same bits everywhere") {
  HostileCases cases(2009);
  for (int i = 0; i < 12; ++i) {
    const HostileCase one = cases.make();
    check("hostile " + std::to_string(i), remodelled_twice(one.surface, one.options));
  }
}

TEST_CASE("a ball in curl noise, with topology handled, has the same bits everywhere") {
  const VelocityField flow = curl_noise({.seed = 3, .wavelength = 1.5});
  Tracker tracker(ball(1, {0.01, 0.02, 0.03}, 6), {.cell_size = 0.2});
  for (int step = 0; step < 10; ++step) {
    tracker.advect(flow, 0.1);
    tracker.remodel();
    tracker.improve();
  }
  check("curl noise", tracker.surface());
}

TEST_CASE("every shape of the catalogue has the same bits everywhere") {
  for (const ShapeInfo& shape : shape_catalogue()) {
    std::map<std::string, double> parameters;
    if (shape.name == "carved_ball")
      parameters["edge_length"] = 0.08;  // by default 70,000 triangles
    check("shape " + shape.name, make_shape(shape.name, parameters));
  }
}
