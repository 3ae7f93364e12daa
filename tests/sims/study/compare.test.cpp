// The measures of a surface against the exact one, where the answer is known.
#include "sims/study/compare.h"

#include <catch2/catch.hpp>
#include <cmath>

#include "kernel/measure/measures.h"
#include "kernel/shapes/shapes.h"
#include "kernel/shapes/transform.h"

using namespace suture;
using namespace suture::sims;

namespace {

double number(const Row& row, const std::string& column) {
  REQUIRE_FALSE(std::isnan(row.number(column)));
  return row.number(column);
}

Truth truth_of(const Triangles& surface) {
  Truth truth;
  truth.exact.surface = surface;
  truth.volume = volume(surface);
  return truth;
}

}  // namespace

TEST_CASE("a shell round a ball is measured by its thickness and its volume") {
  const Triangles ball = sphere({.frequency = 16});
  const Row r = compare(scaled(ball, 1.01), truth_of(ball), {.samples = 5000, .lines = 60});
  CHECK(number(r, "mean_distance") == Approx(0.01).epsilon(0.01));
  CHECK(number(r, "max_distance") == Approx(0.01).epsilon(0.01));
  CHECK(number(r, "volume_error") == Approx(std::pow(1.01, 3) - 1));
  CHECK(number(r, "symmetric_difference") == Approx(std::pow(1.01, 3) - 1).epsilon(0.02));
  CHECK(r.text("crease_mean").empty());
}

TEST_CASE("a box that was moved is as far away as it was moved, and creases tell by how much") {
  const Triangles a = box({.edge_length = 0.5});
  Truth truth = truth_of(a);
  for (std::uint32_t v = 0; v < a.positions.size(); ++v)
    if (a.positions[v].cwiseAbs().minCoeff() == 0.5) truth.exact.corners.push_back(v);
  REQUIRE(truth.exact.corners.size() == 8);
  const Row r = compare(translated(a, {0.02, 0, 0}), truth, {.samples = 5000, .lines = 60});
  CHECK(number(r, "volume_error") == Approx(0).margin(1e-12));
  CHECK(number(r, "symmetric_difference") == Approx(0.04).epsilon(0.05));
  CHECK(number(r, "max_distance") == Approx(0.02));
  // Four corners stick out by 0.02; the other four are on the moved box's sides.
  CHECK(number(r, "corner_max") == Approx(0.02));
  CHECK(number(r, "corner_mean") == Approx(0.01));
}

TEST_CASE("a corner that was rounded off is told from one that is there") {
  const Triangles a = zalesak({.centre = Point::Zero(), .edge_length = 1});
  Truth truth = truth_of(a);
  const double z = std::sqrt(15.0 * 15 - 10 * 10 - 2.5 * 2.5);
  for (std::uint32_t v = 0; v < a.positions.size(); ++v)
    if (a.positions[v][0] == 2.5 && a.positions[v][1] == 10 &&
        std::abs(a.positions[v][2]) > z - 1e-9)
      truth.exact.corners.push_back(v);
  REQUIRE(truth.exact.corners.size() == 2);
  const CompareOptions few{.samples = 1000, .lines = 20};
  CHECK(number(compare(a, truth, few), "corner_max") == 0);
  Triangles rounded = a;
  for (const std::uint32_t v : truth.exact.corners) rounded.positions[v] += Point(-0.5, -0.5, 0);
  CHECK(number(compare(rounded, truth, few), "corner_max") > 0.2);
}

TEST_CASE("markers are measured only where vertices still are markers") {
  const Triangles a = sphere({.frequency = 3});
  const Carry moved = [](const Point& p) -> Point { return p + Point(0.1, 0, 0); };
  const Row r = compare_markers(translated(a, {0.1, 0, 0.003}), a, moved);
  CHECK(number(r, "marker_max") == Approx(0.003));
  CHECK(number(r, "marker_mean") == Approx(0.003));
  CHECK(compare_markers(sphere({.frequency = 4}), a, moved).text("marker_max").empty());
}
