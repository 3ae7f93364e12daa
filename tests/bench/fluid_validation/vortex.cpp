// The vortex of Taylor and Green in a full box: steady without viscosity, with it decaying.
#include <cmath>

#include "tests/bench/fluid_validation/validation.h"
#include "tests/sims/fluid/runs.h"

namespace suture {

using namespace suture::sims;
namespace {

constexpr double kSlow = 1e-4;  // of the speed: so slow that nothing is carried

/// Steps in which a speed of 1 takes a time of 1, so many a cell.
int steps_of(int cells, int a_cell) {
  return static_cast<int>(std::lround(a_cell * cells / std::numbers::pi));
}

/// The vortex runs without viscosity for a time of 1, half a cell a step.
void steady(Rows& rows, int cells) {
  rows.restart();
  Vortex v(cells, 1, {});
  v.advance(1, steps_of(cells, 2));
  const auto [part, rest] = v.part();
  rows.add("_error", cells, 1, rest, 0);
  rows.add("_part", cells, 1, part, 1);
}

/// At a fixed cell size: against the exact flow, and against the finest steps.
void steady_steps(Rows& rows, int cells) {
  constexpr int kMost = 128;
  Vortex finest(cells, 1, {});
  finest.advance(1, kMost);
  const auto limit = finest.faces();
  for (int steps = 4; steps < kMost; steps *= 2) {
    rows.restart();
    Vortex v(cells, 1, {});
    v.advance(1, steps);
    const auto faces = v.faces();
    double sum = 0, all = 0;
    for (std::size_t i = 0; i < faces.size(); ++i) {
      sum += std::pow(faces[i].first - limit[i].first, 2);
      all += std::pow(limit[i].first, 2);
    }
    rows.add("_steps", steps, 1, v.part().second, 0);
    rows.add("_steps_limit", steps, 1, std::sqrt(sum / all), 0);
  }
}

/// The rate at which viscosity takes it, 2ν, from the first step to `lifetimes` of it.
double rate(int cells, double speed, double viscosity, double lifetimes, int steps) {
  FluidOptions options;
  options.viscosity = viscosity;
  Vortex v(cells, speed, options);
  const double time = lifetimes / (2 * viscosity);
  v.advance(time / steps, 1);
  const double first = v.part().first;
  v.advance(time - time / steps, steps - 1);
  return std::log(first / v.part().first) / (time - time / steps);
}

}  // namespace

void vortices(Rows& rows) {
  constexpr double kViscosity = 0.05;
  for (const int cells : {8, 16, 32, 64}) steady(rows, cells);
  for (const int cells : {8, 16, 32}) {
    rows.restart();
    rows.add("_slow_rate", cells, 0.64,
             rate(cells, kSlow, kViscosity, 0.64, std::max(8, cells * cells / 8)), 2 * kViscosity);
    rows.restart();
    rows.add("_rate", cells, 0.2, rate(cells, 1, kViscosity, 0.2, steps_of(cells, 4)),
             2 * kViscosity);
  }
  steady_steps(rows, 32);
  for (int steps = 2; steps <= 64; steps *= 2) {
    rows.restart();
    rows.add("_slow_rate_steps", steps, 0.64, rate(32, kSlow, kViscosity, 0.64, steps),
             2 * kViscosity);
  }
}

}  // namespace suture
