// The collapse of a column of water against Martin and Moyce's experiment of 1952.
#include <fmt/format.h>

#include <cmath>
#include <cstdio>
#include <fstream>
#include <functional>

#include "tests/bench/fluid_validation/equal_steps.h"
#include "tests/bench/fluid_validation/validation.h"
#include "tests/paths.h"

namespace suture {

using namespace suture::sims;
namespace {

using Line = std::vector<std::pair<double, double>>;  // times and values

/// The experiment's Z, the front, at T, or its H, the height at the wall, at τ.
Line experiment(int n2, char quantity) {
  std::ifstream file(source_dir() + "/papers/fluid/martin_moyce.csv");
  Line points;
  for (std::string line; std::getline(file, line);) {
    int n = 0;
    char which = 0;
    double time = 0, value = 0;
    if (std::sscanf(line.c_str(), "%d,%*f,%c,%lf,%lf", &n, &which, &time, &value) == 4 && n == n2 &&
        which == quantity)
      points.emplace_back(time, value);
  }
  return points;
}

double at(const Line& line, double time) {
  for (std::size_t i = 1; i < line.size(); ++i)
    if (line[i].first >= time) {
      const auto& [t0, v0] = line[i - 1];
      const auto& [t1, v1] = line[i];
      return v0 + (time - t0) / (t1 - t0) * (v1 - v0);
    }
  return line.back().second;
}

struct Fallen {
  Line front, film, height;  ///< the tip; where it is half a cell thick; at the wall over n²
  Line energy;               ///< kinetic and potential, over that at first
  double volume = 0;         ///< at the end, over that at first
};

/// Lets the column fall until the time `end`.
Fallen collapse(int n2, int cells, int deep, double end,
                const std::function<void(FluidOptions&)>& change) {
  const double h = 1.0 / cells, frame = 0.05 / std::sqrt(n2);
  FluidOptions options = dam_options(n2, cells, deep);
  change(options);
  Run run = dam_run(n2, options, deep);
  Fallen c{{{0, 1}}, {{0, 1}}, {{0, 1}}, {{0, 1}}, 0};
  const double mass = run.volume(), energy = mass * n2 / 2;
  for (double time = frame; time < end + frame; time += frame) {
    frame_of_equal_steps(run, frame);
    double front = 0, film = 0, height = 0;
    for (const Point& p : run.points()) {
      front = std::max(front, p[0]);
      if (p[1] > 0.5 * h) film = std::max(film, p[0]);
      if (p[0] < h) height = std::max(height, p[1]);
    }
    const LiquidMeasures now = run.fluid.measures();
    c.front.emplace_back(time, front);
    c.film.emplace_back(time, film);
    c.height.emplace_back(time, height / n2);
    c.energy.emplace_back(time - frame / 2, (now.kinetic_energy + now.potential_energy) / energy);
  }
  c.volume = run.volume() / mass;
  return c;
}

void nothing(FluidOptions&) {}

/// Three cells deep: where all slips that is as good as any depth.
constexpr int kThinTank = 3;

/// The last τ; what is left at the wall later is thinner than two cells of the coarsest grid.
constexpr double kEnd = 4.3;

/// The times are those of martin_moyce.csv: T is n times τ.
void dam(Rows& rows, int n2, int cells) {
  const double n = std::sqrt(n2);
  const Line heights = experiment(n2, 'H'), fronts = experiment(n2, 'Z');
  const Fallen c = collapse(n2, cells, kThinTank, kEnd, nothing);
  for (const auto& [when, where] : fronts)
    rows.add(fmt::format(".{}", n2), cells, when, at(c.front, when / n), where);
  for (const auto& [when, height] : heights)
    if (when <= kEnd)
      rows.add(fmt::format("_height.{}", n2), cells, when, at(c.height, when), height);
  rows.add(fmt::format("_volume.{}", n2), cells, c.front.back().first, c.volume, 1);
}

/// The front over time by T, and what is lost of the energy while it runs.
void report(Rows& rows, const std::string& what, int n2, int cells, const Fallen& c,
            const Line& front) {
  const double n = std::sqrt(n2);
  for (const auto& [when, where] : experiment(n2, 'Z'))
    rows.add(fmt::format("_{}.{}", what, n2), cells, when, at(front, when / n), where);
  const double end = experiment(n2, 'Z').back().first / n;
  rows.add(fmt::format("_{}_energy.{}", what, n2), cells, end, at(c.energy, end), 1);
}

}  // namespace

void dams(Rows& rows) {
  for (const int n2 : {2, 1})
    for (const int cells : {8, 16, 32}) {
      rows.restart();
      dam(rows, n2, cells);
    }
}

/// Against potential theory, at the moment that it is let go.
void falls(Rows& rows) {
  for (const int n2 : {2, 1})
    for (const int cells : {8, 16, 32}) {
      rows.restart();
      rows.add(fmt::format(".{}", n2), cells, 0, fall_at_wall(n2, cells), exact_fall_at_wall(n2));
    }
}

/// Tries one at a time what may make the front run ahead of the experiment's. Lengths are in widths
/// of 2.25 inches and g = 1: water's viscosity is 2.3e-5 and its tension 2.3e-3.
void dam_causes(Rows& rows) {
  constexpr int kCells = 16;
  struct Cause {
    std::string name;
    std::function<void(FluidOptions&)> change;
    int deep = kThinTank;
  };
  const auto rubs = [](double viscosity) {
    return [viscosity](FluidOptions& o) { o.viscosity = viscosity; };
  };
  const std::vector<Cause> causes = {
      {"none", nothing},
      {"uncontrolled", [](FluidOptions& o) { o.volume_control.reset(); }},
      {"short_steps", [](FluidOptions& o) { o.cfl = 0.5; }},
      {"semi_lagrangian",
       [](FluidOptions& o) { o.advection = VelocityAdvection::semi_lagrangian; }},
      {"water", rubs(2.3e-5), kCells},
      {"rubs_3e-4", rubs(3e-4), kCells},
      {"slips_3e-3",
       [](FluidOptions& o) {
         o.viscosity = 3e-3;
         o.no_slip = false;
       }},
      {"tension", [](FluidOptions& o) { o.surface_tension = 2.3e-3; }}};
  for (const int n2 : {2, 1})
    for (const Cause& cause : causes) {
      rows.restart();
      const double end = experiment(n2, 'Z').back().first / std::sqrt(n2);
      const Fallen c = collapse(n2, kCells, cause.deep, end, cause.change);
      report(rows, cause.name, n2, kCells, c, c.front);
      if (cause.name == "none") report(rows, "film", n2, kCells, c, c.film);
    }
}

}  // namespace suture
