// A twisted ball: its decay by viscosity, swing by elasticity, yielding, and flight.
#include <fmt/format.h>

#include <cmath>

#include "tests/bench/fluid_validation/validation.h"
#include "tests/sims/fluid/runs.h"

namespace suture {

using namespace suture::sims;
namespace {

constexpr double kSlow = 1e-3;  // of the twist: the ball stays one

double twist_of(const Run& run, double size) {
  return twisted(run.fluid, size, kMiddle, Point::Zero()).first;
}

/// The period is twice what is between two zeros; another row has what is left at the turn.
void swing(Rows& rows, const std::string& what, int cells, double modulus) {
  FluidOptions options;
  options.viscoelasticity = ElasticOptions{.modulus = modulus};
  Run run = twisted_ball(cells, kSlow, options);
  const double period = 2 * std::numbers::pi / (kFree * std::sqrt(modulus));
  const int steps = std::max(80, 8 * cells);
  const double dt = period / steps;
  std::vector<double> zeros;
  double before = 1, turned = 0;
  for (int i = 0; i < steps && zeros.size() < 2; ++i) {
    run.fluid.step(*run.surface, dt);
    const double now = twist_of(run, kSlow);
    if (before * now < 0) zeros.push_back((i + 0.5 - now / (now - before)) * dt);
    turned = std::min(turned, now);
    before = now;
  }
  if (zeros.size() < 2) return;
  const double is = 2 * (zeros[1] - zeros[0]);
  if (what == "_modulus") {
    rows.add(what, modulus, zeros[1], is, period);
    return;
  }
  rows.add("_period", cells, zeros[1], is, period);
  rows.add("_turned", cells, period / 2, -turned, 1);
}

}  // namespace

/// Viscosity 1: the twist decays at k². From the middle of the first step on.
void shear(Rows& rows) {
  for (const int cells : {6, 12}) {
    rows.restart();
    FluidOptions options;
    options.viscosity = 1;
    Run run = twisted_ball(cells, kSlow, options);
    const double rate = kFree * kFree, part = 0.02;  // of a lifetime a step
    double first = 0, now = 0;
    for (int i = 0; i <= 40; ++i) {
      run.fluid.step(*run.surface, part / rate);
      if (i % 4 != 0) continue;
      now = twist_of(run, kSlow);
      if (i == 0) first = now;
      rows.add("_amplitude", cells, i * part, now / first, std::exp(-i * part));
    }
    rows.add("_rate", cells, 40 * part, -std::log(now / first) / (40 * part) * rate, rate);
  }
}

void elastic(Rows& rows) {
  for (const int cells : {6, 12}) {
    rows.restart();
    swing(rows, "_period", cells, 1);
  }
  for (const double modulus : {1e-2, 1e2, 1e6}) {
    rows.restart();
    swing(rows, "_modulus", 6, modulus);
  }
}

void yielding(Rows& rows) {
  for (const double yield : {0.001, 0.03})
    for (const double size : {4.0, 12.0, 24.0, 48.0}) {
      rows.restart();
      const auto [most, left] = lasting_strain(4, size * yield, yield);
      rows.add("_left", yield, most / yield, left / yield, std::max(0.0, most / yield - 1));
    }
}

/// A twisted ball that flies half its radius and some: what of its velocity is off.
void translation(Rows& rows) {
  const Point drift(0.53, 0.21, 0.11);
  for (const int cells : {6, 12, 24}) {
    rows.restart();
    Run run = twisted_ball(cells, kSlow, {}, drift);
    const std::vector<Point> start = run.points();
    const int steps = cells;
    for (int i = 0; i < steps; ++i) run.fluid.step(*run.surface, 1.0 / steps);
    const double moved = 1 - 0.5 / steps;  // the velocity is half a step behind
    rows.add("_velocity", cells, 1,
             twisted(run.fluid, kSlow, kMiddle + moved * drift, drift).second, 0);
    double off = 0;
    for (std::size_t i = 0; i < start.size(); ++i) {
      const Point should = start[i] + drift + kSlow * twist(start[i] - kMiddle);
      off = std::max(off, (run.points()[i] - should).norm());
    }
    rows.add("_position", cells, 1, off / kSlow, 0);
    Run rigid = twisted_ball(cells, 0, {}, drift);
    for (int i = 0; i < steps; ++i) rigid.fluid.step(*rigid.surface, 1.0 / steps);
    off = 0;
    for (std::size_t i = 0; i < start.size(); ++i)
      off = std::max(off, (rigid.points()[i] - start[i] - drift).norm());
    rows.add("_rigid", cells, 1, off, 0);
  }
}

}  // namespace suture
