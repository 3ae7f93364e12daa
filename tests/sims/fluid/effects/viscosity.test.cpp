#include "sims/fluid/effects/viscosity.h"

#include <catch2/catch.hpp>
#include <limits>

#include "kernel/errors.h"
#include "tests/sims/fluid/blobs.h"

namespace suture {

using namespace suture::sims;
namespace {

const Point kMiddle{0.013, 0.027, -0.017};  // nowhere special on the grid
constexpr double kRadius = 0.93;
constexpr double kFree = 5.763459197;    // k·R of the slowest torsion without a torque at R
constexpr double kClosed = 4.493409458;  // and of that which is 0 at R

double ball(const Point& p) { return (p - kMiddle).norm() - kRadius; }
Point still(const Point&) { return Point::Zero(); }

/// Nothing regular, of a size about 1.
Point stirred(const Point& p) {
  return {std::sin(7 * p[1]) + 0.3, std::cos(5 * p[0] * p[2]), 9 * p[0] * p[1] - 1};
}

/// A ball of cells of size 1/n, in air or in a closed solid, that torsion k·R slows: the relative
/// errors of its rate of decay and of its velocity after a step of half its lifetime.
std::pair<double, double> decay_errors(int n, double k, bool closed) {
  const double h = 1.0 / n;
  Blob blob(n + 2, h, closed ? [](const Point&) { return -1.0; } : Formula(ball));
  if (closed) blob.add_solids([](const Point& p) { return -ball(p); }, still);
  const MacVelocity before =
      blob.velocity([&](const Point& p) { return torsion(k / kRadius)(p - kMiddle); });
  MacVelocity v = before, exact = before;
  const ViscosityOptions viscosity{3, 2, true};
  const double rate = 1.5 * k * k / (kRadius * kRadius), dt = 0.5 / rate;
  CHECK(diffuse(v, {blob.liquid, blob.solids}, viscosity, {dt, {1e-8, 1000}}).converged());
  const VolumeFractions fractions = volume_fractions(blob.liquid);
  for (auto& u : exact.u)
    for (double& x : u) x /= 1.5;
  const MacVelocity none = blob.velocity(still);
  return {std::abs((1 / part_of(v, before, fractions, blob.solids) - 1) / (rate * dt) - 1),
          difference(v, exact, fractions, blob.solids) /
              difference(exact, none, fractions, blob.solids)};
}

/// Two balls, of which a wall may touch the larger.
Blob two_balls(int n) {
  return Blob(n + 4, 1.0 / n, [](const Point& p) {
    return std::min((p - kMiddle).norm() - 0.6, (p - Point(-0.7, 0.3, 0.75)).norm() - 0.17);
  });
}
double slope(const Point& p) { return p[2] + 0.5 + 0.3 * p[0]; }

double largest_strain_rate(const MacVelocity& v, const Blob& blob) {
  const VolumeFractions fractions = volume_fractions(blob.liquid);
  const StrainRate rate(fractions, blob.solids, WallSlip::none);
  double most = 0;
  rate.for_each(
      [&](const RateStencil& r, int, Slot) { most = std::max(most, std::abs(rate.value(r, v))); });
  return most;
}

TEST_CASE("a twisted ball in air slows at the exact rate, to second order") {
  const auto [rate_6, velocity_6] = decay_errors(6, kFree, false);
  const auto [rate_12, velocity_12] = decay_errors(12, kFree, false);
  const auto [rate_24, velocity_24] = decay_errors(24, kFree, false);
  CAPTURE(rate_6, rate_12, rate_24, velocity_6, velocity_12, velocity_24);
  CHECK(rate_24 < 0.004);
  CHECK(std::log2(rate_6 / rate_12) > 1.8);
  CHECK(std::log2(rate_12 / rate_24) > 1.8);
  CHECK(std::log2(velocity_6 / velocity_12) > 1.8);
  CHECK(std::log2(velocity_12 / velocity_24) > 1.8);
}

TEST_CASE("a twisted ball in a solid slows at the exact rate, to order 1.7") {
  const auto [rate_6, velocity_6] = decay_errors(6, kClosed, true);
  const auto [rate_12, velocity_12] = decay_errors(12, kClosed, true);
  const auto [rate_24, velocity_24] = decay_errors(24, kClosed, true);
  CAPTURE(rate_6, rate_12, rate_24, velocity_6, velocity_12, velocity_24);
  CHECK(rate_24 < 0.002);
  CHECK(std::log2(rate_6 / rate_24) / 2 > 1.6);
  CHECK(std::log2(velocity_6 / velocity_12) > 1.3);
  CHECK(std::log2(velocity_12 / velocity_24) > 1.3);
}

TEST_CASE("what turns and moves as a rigid body is not slowed, at any viscosity") {
  const Blob blob(12, 0.1, ball);
  const MacVelocity before = blob.velocity(
      [](const Point& p) -> Point { return Point(1, 2, -1) + Point(3, -1, 2).cross(p); });
  for (const double viscosity : {1e-3, 1.0, 1e4, 1e9}) {
    MacVelocity v = before;
    const DiffusionReport report = diffuse(v, {blob.liquid, {}}, {viscosity, 1, true}, {1});
    CHECK(report.iterations == 0);
    CHECK(difference(v, before, volume_fractions(blob.liquid)) < 1e-13);
  }
}

TEST_CASE("free liquid keeps its momenta to rounding") {
  const Blob blob = two_balls(12);
  const VolumeFractions fractions = volume_fractions(blob.liquid);
  const MacVelocity before = blob.velocity(stirred);
  const Moments was = moments(before, fractions);
  for (const double viscosity : {1e-3, 1.0, 1e6}) {
    MacVelocity v = before;
    CHECK(diffuse(v, {blob.liquid, {}}, {viscosity, 1, true}, {1, {1e-3, 500}}).converged());
    const Moments is = moments(v, fractions);
    CHECK((is.momentum - was.momentum).norm() < 1e-13 * was.momentum.norm());
    CHECK((is.spin - was.spin).norm() < 1e-12 * was.spin.norm());
    CHECK(difference(v, before, fractions) > 0.01);
  }
}

TEST_CASE("the stiffest free liquid moves as a rigid body, and at a wall it stands") {
  Blob blob = two_balls(12);
  const VolumeFractions fractions = volume_fractions(blob.liquid);
  const MacVelocity before = blob.velocity(stirred);
  MacVelocity v = before;
  CHECK(diffuse(v, {blob.liquid, {}}, {1e15, 1, true}, {1}).converged());
  CHECK(largest_strain_rate(v, blob) < 1e-11);
  CHECK(moments(v, fractions).energy > 0.7 * moments(before, fractions).energy);

  blob.add_solids(slope, still);
  MacVelocity at_wall = before;
  CHECK(diffuse(at_wall, {blob.liquid, blob.solids}, {1e15, 1, true}, {1}).converged());
  double most = 0, droplet = 0;
  for (Slot s = 0; s < blob.grid->size(); ++s) {
    if (!blob.liquid.inside(s)) continue;
    double& where = (blob.grid->centre(blob.grid->cell(s)) - kMiddle).norm() < 0.6 ? most : droplet;
    for (int a = 0; a < 3; ++a) where = std::max(where, std::abs(at_wall.u[a][s]));
  }
  CHECK(most < 1e-9);
  CHECK(droplet > 1);
}

TEST_CASE("no viscosity changes nothing and costs nothing") {
  const Blob blob = two_balls(6);
  const MacVelocity before = blob.velocity(stirred);
  MacVelocity v = before;
  const DiffusionReport report = diffuse(v, {blob.liquid, {}}, {0, 1, true}, {1});
  CHECK((v.u == before.u));
  CHECK(report.iterations == 0);
  CHECK(report.memory == 0);
}

TEST_CASE("viscosity never adds kinetic energy, and more of it leaves less") {
  Blob blob = two_balls(8);
  blob.add_solids(slope, still);
  const VolumeFractions fractions = volume_fractions(blob.liquid);
  MacVelocity before = blob.velocity(stirred);
  // held faces as they are to be
  CHECK(diffuse(before, {blob.liquid, blob.solids}, {1e-30, 1, true}, {1}).converged());
  for (const bool no_slip : {false, true}) {
    double last = moments(before, fractions, blob.solids).energy;
    for (double viscosity = 1e-6; viscosity < 1e14; viscosity *= 100) {
      MacVelocity v = before;
      CHECK(diffuse(v, {blob.liquid, blob.solids}, {viscosity, 1, no_slip}, {1}).converged());
      const double energy = moments(v, fractions, blob.solids).energy;
      CHECK(energy <= last * (1 + 1e-6));
      last = energy;
    }
  }
}

TEST_CASE("over fourteen decades of viscosity the velocity's error is about the tolerance") {
  Blob blob = two_balls(10);
  const bool wall = GENERATE(false, true);
  const Point drift(1, 0, 0.5);  // all walls may move: only what differs counts
  if (wall) blob.add_solids(slope, [&](const Point&) { return drift; });
  const VolumeFractions fractions = volume_fractions(blob.liquid);
  const MacVelocity before = blob.velocity(stirred);
  for (double viscosity = 1e-6; viscosity < 1e10; viscosity *= 1000) {
    MacVelocity v = before, better = before;
    const DiffusionReport report =
        diffuse(v, {blob.liquid, blob.solids}, {viscosity, 1, true}, {1});
    CHECK(diffuse(better, {blob.liquid, blob.solids}, {viscosity, 1, true}, {1, {1e-11, 5000}})
              .converged());
    CHECK(report.residual <= 1e-6);
    CHECK(report.iterations <= 300);
    CHECK(difference(v, better, fractions) <
          2e-6);  // measured: 1e-6 and less, of a velocity of 1.7
  }
}

TEST_CASE("liquid slips along a wall where it may, and not where it may not") {
  const double h = 0.1;
  Blob blob(10, h, [](const Point& p) { return p.head(2).norm() - 0.55; });  // a column
  for (double& d : blob.liquid.distance) d = std::max(d, -h);
  blob.add_solids([](const Point& p) { return 0.43 - std::abs(p[2]); }, still);
  const MacVelocity before = blob.velocity([](const Point&) { return Point(1, 2, 0); });
  MacVelocity slips = before, stops = before;
  CHECK(diffuse(slips, {blob.liquid, blob.solids}, {1, 1, false}, {1}).converged());
  CHECK(diffuse(stops, {blob.liquid, blob.solids}, {1, 1, true}, {1}).converged());
  const VolumeFractions fractions = volume_fractions(blob.liquid);
  CHECK(difference(slips, before, fractions, blob.solids) < 1e-13);
  CHECK(moments(stops, fractions).energy < 0.05 * moments(before, fractions).energy);
}

TEST_CASE("liquid that has not come to a wall does not stick to it, one that has does") {
  for (const double gap : {0.0, 0.8}) {  // cells
    const double h = 0.1;
    Blob blob(8, h, [&](const Point& p) { return std::max(gap * h - p[2], p.norm() - 0.5); });
    blob.add_solids([](const Point& p) { return p[2] < 0 ? p[2] : 1; }, still);
    for (Slot s = 0; s < blob.grid->size(); ++s) {  // as Liquid continues it into solids
      const Point p = blob.grid->centre(blob.grid->cell(s));
      if (p[2] < 0 && gap == 0) blob.liquid.distance[s] = p.head(2).norm() - 0.5;
    }
    MacVelocity v = blob.velocity([](const Point&) { return Point(0, 0, 1); });
    const VolumeFractions fractions = volume_fractions(blob.liquid);
    const Moments before = moments(v, fractions, blob.solids);
    CHECK(diffuse(v, {blob.liquid, blob.solids}, {1e6, 1, true}, {1}).converged());
    const double left = moments(v, fractions, blob.solids).momentum[2] / before.momentum[2];
    CHECK(left == Approx(gap == 0 ? 0 : 1).margin(1e-3));
  }
}

TEST_CASE("viscosity is the same in any unit") {
  const MacVelocity* last = nullptr;
  std::vector<MacVelocity> results;
  for (const double unit : {1.0, 0x1p-60, 0x1p80}) {
    Blob blob(8, unit / 8, [&](const Point& p) { return unit * ball(p / unit); });
    MacVelocity v = blob.velocity([&](const Point& p) { return stirred(p / unit); });
    CHECK(diffuse(v, {blob.liquid, {}}, {0x1p-40 * unit, 0x1p-40 / unit, true}, {0x1p-4})
              .converged());
    results.push_back(std::move(v));
  }
  for (const MacVelocity& v : results) {
    if (last != nullptr) CHECK((v.u == last->u));
    last = &v;
  }
}

TEST_CASE("viscosity refuses what is no viscosity, and velocities that are not finite") {
  const Blob blob = two_balls(6);
  MacVelocity v = blob.velocity(stirred);
  const double bad = std::numeric_limits<double>::quiet_NaN();
  CHECK_THROWS_AS(diffuse(v, {blob.liquid, {}}, {-1, 1, true}, {1}), InvalidInput);
  CHECK_THROWS_AS(diffuse(v, {blob.liquid, {}}, {bad, 1, true}, {1}), InvalidInput);
  CHECK_THROWS_AS(diffuse(v, {blob.liquid, {}}, {1, 0, true}, {1}), InvalidInput);
  CHECK_THROWS_AS(diffuse(v, {blob.liquid, {}}, {1, 1, true}, {-1}), InvalidInput);
  for (double& u : v.u[1]) u = bad;
  CHECK_THROWS_AS(diffuse(v, {blob.liquid, {}}, {1, 1, true}, {1}), InvalidInput);
}

}  // namespace
}  // namespace suture
