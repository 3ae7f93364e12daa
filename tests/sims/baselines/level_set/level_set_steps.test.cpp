#include <catch2/catch.hpp>
#include <cmath>
#include <numbers>

#include "sims/baselines/level_set/mac_cormack.h"
#include "sims/baselines/level_set/upwind_advection.h"

using namespace suture;
using namespace suture::sims;

namespace {

// φ = sin(2π x / length), `thick` nodes wide, moved along x; far from the ends nothing of the ends
// is felt. Its border is far above φ, so that no node leaves the band.
openvdb::FloatGrid::Ptr wave(int length, int thick) {
  const auto grid = openvdb::FloatGrid::create(10);
  grid->setTransform(openvdb::math::Transform::createLinearTransform(1.0));
  grid->setGridClass(openvdb::GRID_LEVEL_SET);
  auto values = grid->getAccessor();
  for (int i = -2 * length; i <= 2 * length; ++i)
    for (int j = -thick; j <= thick; ++j)
      for (int k = -thick; k <= thick; ++k)
        values.setValue({i, j, k}, static_cast<float>(std::sin(2 * std::numbers::pi * i / length)));
  return grid;
}

double mean_error(const openvdb::FloatGrid& grid, int length, double moved) {
  auto values = grid.getConstAccessor();
  double sum = 0;
  for (int i = -length / 2; i < length / 2; ++i)
    sum += std::abs(static_cast<double>(values.getValue({i, 0, 0})) -
                    std::sin(2 * std::numbers::pi * (i - moved) / length));
  return sum / length;
}

const VelocityField along_x = [](const Point&, double) { return Point(1, 0, 0); };

double upwind_error(int length, UpwindScheme scheme) {
  LevelSetOptions o;
  o.scheme = scheme;
  o.time_order = 3;
  const auto grid = wave(length, 0);
  const GridVelocity u{along_x, Point::Zero(), 1};
  const int steps = 2 * length;  // 0.05 cells each: the error in time is nothing
  for (int i = 0; i < steps; ++i) advect_upwind(*grid, u, {0.05 * i, 0.05, false}, o);
  return mean_error(*grid, length, 0.05 * steps);
}

double mac_cormack_error(int length, Limiter limiter) {
  auto grid = wave(length, 3);
  const GridVelocity u{along_x, Point::Zero(), 1};
  const int steps = length / 4;
  for (int i = 0; i < steps; ++i) grid = mac_cormack(*grid, u, {{0.4 * i, 0.4, 2}, limiter});
  return mean_error(*grid, length, 0.4 * steps);
}

}  // namespace

TEST_CASE("upwind schemes are of the order that they are published with") {
  const auto order = [](UpwindScheme scheme, int length) {
    return std::log2(upwind_error(length, scheme) / upwind_error(2 * length, scheme));
  };
  CHECK(order(UpwindScheme::first, 24) == Approx(1).margin(0.15));
  CHECK(order(UpwindScheme::second, 24) == Approx(2).margin(0.4));
  CHECK(order(UpwindScheme::third, 24) == Approx(3).margin(0.4));
  // Beyond 32 nodes a wave its error is that of single precision.
  CHECK(order(UpwindScheme::weno5, 12) == Approx(5).margin(0.5));
}

TEST_CASE("MacCormack's step is of second order, and a limiter costs some of it at extrema") {
  const auto order = [](Limiter limiter) {
    return std::log2(mac_cormack_error(16, limiter) / mac_cormack_error(32, limiter));
  };
  CHECK(order(Limiter::none) == Approx(2).margin(0.2));
  CHECK(order(Limiter::clamp) > 1.5);
  CHECK(order(Limiter::revert) > 1.2);
}

TEST_CASE("a limited MacCormack step makes no new extrema of a jump, an unlimited one does") {
  for (const Limiter limiter : {Limiter::clamp, Limiter::revert, Limiter::none}) {
    auto grid = wave(16, 3);
    for (auto at = grid->beginValueOn(); at; ++at) at.setValue(at.getCoord()[0] < 0 ? -1.0F : 1.0F);
    const GridVelocity u{along_x, Point::Zero(), 1};
    for (int i = 0; i < 4; ++i) grid = mac_cormack(*grid, u, {{0.4 * i, 0.4, 2}, limiter});
    auto values = grid->getConstAccessor();
    float most = 0;
    for (int i = -8; i < 8; ++i) most = std::max(most, std::abs(values.getValue({i, 0, 0})));
    CHECK((most > 1.01F) == (limiter == Limiter::none));
  }
}
