// The fluid solver against experiment, formulas and what has to be kept; as CSV, case by case.
#include <fmt/format.h>

#include <cmath>
#include <cstdio>
#include <ctime>
#include <fstream>
#include <map>
#include <numbers>

#include "kernel/measures.h"
#include "kernel/shapes.h"
#include "kernel/transform.h"
#include "sims/fluid/fluid.h"
#include "sims/rivals/mesh_tracker.h"
#include "tests/sims/fluid/blobs.h"
#include "tests/sims/fluid/drops.h"

using namespace suture;

namespace {

constexpr double kPi = std::numbers::pi;

double cpu_seconds() { return static_cast<double>(std::clock()) / CLOCKS_PER_SEC; }

/// Rows of one case; `error` is relative to what is exact, or the figure itself where that is 0.
struct Rows {
  std::string name, text;
  double from = cpu_seconds();

  void add(const std::string& what, double resolution, double time, double measured, double exact) {
    const double error = exact == 0 ? measured : measured / exact - 1;
    const std::string row =
        fmt::format("{}{},{},{:.5g},{:.6g},{:.6g},{:.3g},{:.2f}\n", name, what, resolution, time,
                    measured, exact, error, cpu_seconds() - from);
    fmt::print("{}", row);
    std::fflush(stdout);
    text += row;
  }
  void restart() { from = cpu_seconds(); }
};

/// A surface and the liquid in it.
struct Run {
  std::unique_ptr<SurfaceTracker> surface;
  Fluid fluid;

  Run(const Triangles& start, double cell, const FluidOptions& options, Fluid::Initial initial,
      const MeshSchedule& schedule)
      : fluid(options, std::move(initial)) {
    TrackerOptions tracker;
    tracker.cell_size = cell;
    tracker.origin = Point(0.011, 0.013, 0.007) * cell;
    tracker.quality.keep_features = false;
    tracker.quality.subdivision = Subdivision::fitted;
    surface = make_mesh_tracker(start, tracker, schedule);
  }
  void frame(double dt) {
    const int steps = fluid.steps_in(dt);
    for (int i = 0; i < steps; ++i) fluid.step(*surface, dt / steps);
    fluid.before_remodel(surface->surface());
    surface->settle();
    fluid.after_remodel(surface->surface());
  }
  double fastest() {
    double most = 0;
    for (const Point& p : surface->surface().positions)
      most = std::max(most, fluid.velocity(p).norm());
    return most;
  }
};

constexpr MeshSchedule kMarkers{0, 0}, kPerFrame{kWhenItSettles, kWhenItSettles}, kNoMerges{0, 1};

Point at_rest(const Point&) { return Point::Zero(); }

SolidOptions container(const Point& low, const Point& high) {
  SolidOptions s;
  s.box = {low, high};
  return s;
}

// --- Martin and Moyce 1952

/// (T, Z) of the experiment.
std::vector<std::pair<double, double>> experiment(int n2) {
  std::ifstream file(SUTURE_SOURCE_DIR "/papers/fluid/martin_moyce.csv");
  std::vector<std::pair<double, double>> points;
  for (std::string line; std::getline(file, line);) {
    int n = 0;
    double time = 0, value = 0;
    if (std::sscanf(line.c_str(), "%d,%*f,Z,%lf,%lf", &n, &time, &value) == 3 && n == n2)
      points.emplace_back(time, value);
  }
  return points;
}

/// A column 1 wide and n² high in a tank three cells deep, g = 1.
void dam(Rows& rows, int n2, int cells) {
  const double h = 1.0 / cells, depth = 3 * h;
  FluidOptions options;
  options.cell_size = h;
  options.gravity = {0, -1, 0};
  options.volume_control.emplace();
  options.solids = {container({0, 0, 0}, {8, n2 + 2.0, depth})};
  Run run(box({.centre = Point(1, n2, depth) / 2, .size = Point(1, n2, depth), .edge_length = h}),
          h, options, at_rest, kPerFrame);
  double time = 0, front = 1;
  const double root = std::sqrt(n2), frame = 0.05 / root;
  for (const auto& [when, where] : experiment(n2)) {
    double before = time, was = front;
    while (time * root < when) {
      before = time;
      was = front;
      run.frame(frame);
      time += frame;
      front = 0;
      for (const Point& p : run.surface->surface().positions) front = std::max(front, p[0]);
    }
    const double part = time > before ? (when / root - before) / (time - before) : 1;
    rows.add(fmt::format(".{}", n2), cells, when, was + part * (front - was), where);
  }
  rows.add(fmt::format("_volume.{}", n2), cells, time * root, volume(run.surface->surface()),
           n2 * depth);
}

void dams(Rows& rows) {
  for (const int n2 : {2, 1})
    for (const int cells : {8, 16}) {
      rows.restart();
      dam(rows, n2, cells);
    }
}

// --- Drops under tension: tension, density and cells are 1

FluidOptions drop_options() {
  FluidOptions options;
  options.cell_size = options.density = 1;
  options.surface_tension = 1;
  options.pressure.tolerance = 1e-8;
  return options;
}

double drop_period(double radius) { return 2 * kPi * std::sqrt(radius * radius * radius / 8); }

/// The share of the second Legendre polynomial about z in r/R, by solid angles.
double bend(const Triangles& s, double radius) {
  double sum = 0, whole = 0;
  for (const Triangle& t : s.triangles) {
    const Point a = s.positions[t[0]] - kDropCentre, b = s.positions[t[1]] - kDropCentre,
                c = s.positions[t[2]] - kDropCentre, middle = (a + b + c) / 3;
    const double z = middle.normalized()[2];
    const double angle = a.dot(b.cross(c)) / std::pow(middle.norm(), 3);
    sum += angle * middle.norm() / radius * (1.5 * z * z - 0.5);
    whole += angle;
  }
  return 5 * sum / whole;
}

/// From its second zero to its first, times two; and what is left of its amplitude where it turns.
void drop_swings(Rows& rows, double radius, double edge) {
  constexpr double kBend = 0.05;
  Triangles start = sphere({Point::Zero(), radius, edge, 0, 1});
  for (Point& p : start.positions) {
    const double z = p.normalized()[2];
    p *= 1 + kBend * (1.5 * z * z - 0.5);
  }
  Run run(translated(start, kDropCentre), edge, drop_options(), at_rest, kNoMerges);
  const double period = drop_period(radius);
  const int steps = run.fluid.steps_in(period);
  double before = kBend, turned = 0;
  std::vector<double> zeros;
  for (int i = 1; i <= steps && zeros.size() < 2; ++i) {
    run.fluid.step(*run.surface, period / steps);
    const double now = bend(run.surface->surface(), radius);
    if (before * now < 0) zeros.push_back((i - now / (now - before)) / steps * period);
    if (i % std::max(1, steps / 40) == 0)
      rows.add("_bend", radius, i * period / steps / period, now / kBend,
               std::cos(2 * kPi * i / steps));
    turned = std::min(turned, now);
    before = now;
  }
  if (zeros.size() < 2) return;
  rows.add("_period", radius, zeros[1], 2 * (zeros[1] - zeros[0]), period);
  rows.add("_turned", radius, period / 2, -turned / kBend, 1);
}

void drops(Rows& rows) {
  for (const double radius : {4.0, 8.0, 16.0}) {
    rows.restart();
    drop_swings(rows, radius, 0.9);
  }
}

/// A remodelled, irregular mesh of a ball at rest, for half a period.
void currents(Rows& rows) {
  for (const double radius : {4.0, 8.0}) {
    rows.restart();
    const double time = drop_period(radius) / 2, speed = std::sqrt(1 / radius);
    Run run(remodelled(radius, 0.8), 0.8, drop_options(), at_rest, kNoMerges);
    const int steps = run.fluid.steps_in(time);
    double most = 0;
    for (int i = 0; i < steps; ++i) {
      run.fluid.step(*run.surface, time / steps);
      most = std::max(most, run.fastest());
    }
    rows.add("_most", radius, time, most / speed, 0);
    rows.add("_end", radius, time, run.fastest() / speed, 0);
  }
}

// --- A ball that is twisted: a shear wave that its free surface reflects

const Point kMiddle{0.013, 0.027, -0.017};
constexpr double kFree = 5.763459197;  // k·R of the slowest torsion without a torque at R
constexpr double kTwist = 1e-3;        // so slow that the ball stays one

Point twist(const Point& p) { return torsion(kFree)(p); }

/// The part of the twist in the liquid of the ball about `middle` that moves with `drift`, and the
/// root of the mean square of what is else, relative to the twist's.
std::pair<double, double> twisted(const Fluid& fluid, const Point& middle, const Point& drift) {
  double part = 0, all = 0, rest = 0;
  Random random(5);
  std::vector<std::pair<Point, Point>> samples;
  while (samples.size() < 2000) {
    const Point p = random_vector(random);
    if (p.norm() > 1) continue;
    samples.emplace_back(twist(p), (fluid.velocity(middle + p) - drift) / kTwist);
    part += samples.back().first.dot(samples.back().second);
    all += samples.back().first.squaredNorm();
  }
  for (const auto& [should, is] : samples) rest += (is - should).squaredNorm();
  return {part / all, std::sqrt(rest / all)};
}

Run twisted_ball(int cells, FluidOptions options, const Point& drift = Point::Zero()) {
  options.cell_size = 1.0 / cells;
  options.density = 1;
  options.pressure.tolerance = options.viscous_solver.tolerance = 1e-8;
  return {sphere({.centre = kMiddle, .edge_length = 0.9 / cells, .exact_volume = 1}), 1.0 / cells,
          options, [drift](const Point& p) -> Point { return drift + kTwist * twist(p - kMiddle); },
          kMarkers};
}

/// Viscosity 1: the twist decays at k². Between the first step and 60 hundredths of a lifetime.
void shear(Rows& rows) {
  for (const int cells : {6, 12}) {
    rows.restart();
    FluidOptions options;
    options.viscosity = 1;
    Run run = twisted_ball(cells, options);
    const double rate = kFree * kFree, dt = 0.02 / rate;
    double first = 0, now = 0;
    for (int i = 0; i < 40; ++i) {
      run.fluid.step(*run.surface, dt);
      now = twisted(run.fluid, kMiddle, Point::Zero()).first;
      if (i == 0) first = now;
      if (i % 4 == 3)
        rows.add("_amplitude", cells, (i + 0.5) * 0.02, now, std::exp(-(i + 0.5) * 0.02));
    }
    rows.add("_rate", cells, 0.8, std::log(first / now) / (39 * dt), rate);
  }
}

/// Modulus 1: it swings with k; from its second zero to its first.
void elastic(Rows& rows) {
  for (const int cells : {6, 12}) {
    rows.restart();
    FluidOptions options;
    options.viscoelasticity = ElasticOptions{.modulus = 1};
    Run run = twisted_ball(cells, options);
    const double period = 2 * kPi / kFree, dt = period / 80;
    std::vector<double> zeros;
    double before = 1, turned = 0;
    for (int i = 0; i < 80 && zeros.size() < 2; ++i) {
      run.fluid.step(*run.surface, dt);
      const double now = twisted(run.fluid, kMiddle, Point::Zero()).first;
      if (before * now < 0) zeros.push_back((i + 0.5 - now / (now - before)) * dt);
      turned = std::min(turned, now);
      before = now;
    }
    if (zeros.size() < 2) continue;
    rows.add("_period", cells, zeros[1], 2 * (zeros[1] - zeros[0]), period);
    rows.add("_turned", cells, period / 2, -turned, 1);
  }
}

/// A twisted ball that flies half its radius and some: what of its velocity is off.
void translation(Rows& rows) {
  const Point drift(0.53, 0.21, 0.11);
  for (const int cells : {6, 12, 24}) {
    rows.restart();
    Run run = twisted_ball(cells, {}, drift);
    const int steps = cells;
    for (int i = 0; i < steps; ++i) run.fluid.step(*run.surface, 1.0 / steps);
    const double moved = 1 - 0.5 / steps;  // the velocity is half a step behind
    rows.add("_velocity", cells, 1, twisted(run.fluid, kMiddle + moved * drift, drift).second, 0);
  }
}

// --- What has to stay as it is

void still_water(Rows& rows) {
  const double height = 0.437, cell = 0.125;
  FluidOptions options;
  options.cell_size = cell;
  options.gravity = {0, -10, 0};
  options.pressure.tolerance = 1e-12;
  options.solids = {container({0, 0, 0}, {1, 1, 0.5})};
  Run run(box({.centre = {0.5, height / 2, 0.25}, .size = {1, height, 0.5}, .edge_length = cell}),
          cell, options, at_rest, kMarkers);
  double most = 0;
  for (int i = 0; i < 1000; ++i) {
    run.fluid.step(*run.surface, 0.02);
    most = std::max(most, run.fastest());
  }
  rows.add("_velocity", 1 / cell, 20, most / std::sqrt(10 * height), 0);
  rows.add("_volume", 1 / cell, 20, volume(run.surface->surface()), height / 2);
}

/// One drop hits another, off its middle. Cells and radii are 1/6 and 1.
void meeting(Rows& rows, bool control) {
  const double h = 1.0 / 6;
  FluidOptions options;
  options.cell_size = h;
  options.density = 1;
  if (control) options.volume_control.emplace();
  const std::vector balls = {
      sphere({.centre = kMiddle, .edge_length = h, .exact_volume = 1}),
      sphere({.centre = kMiddle + Point(2.2, 0.5, 0), .edge_length = h, .exact_volume = 1})};
  const Triangles start = merged(balls);
  const Point velocity(1, 0.1, 0);
  Run run(
      start, h, options,
      [&](const Point& p) -> Point { return p[0] < 1.1 ? velocity : Point::Zero(); }, kPerFrame);
  const double ball = 4 * kPi / 3, whole = volume(start);
  double energy = 0, most_energy = 0;
  for (int i = 0; i < 30; ++i) {
    run.frame(0.05);
    const double now = run.fluid.measures().kinetic_energy;
    if (i == 0) energy = now;
    most_energy = std::max(most_energy, now);
  }
  const Point momentum = run.fluid.measures().momentum;
  const std::string with = control ? "_controlled" : "";
  rows.add("_momentum_x" + with, 6, 1.5, momentum[0], ball * velocity[0]);
  rows.add("_momentum_y" + with, 6, 1.5, momentum[1], ball * velocity[1]);
  rows.add("_volume" + with, 6, 1.5, volume(run.surface->surface()), whole);
  rows.add("_energy_most" + with, 6, 1.5, most_energy, energy);
  rows.add("_bodies" + with, 6, 1.5, static_cast<double>(components(run.surface->surface()).count),
           1);
}

void meetings(Rows& rows) {
  for (const bool control : {false, true}) {
    rows.restart();
    meeting(rows, control);
  }
}

const std::map<std::string, void (*)(Rows&)> kCases = {
    {"dam", dams},          {"drop", drops},      {"currents", currents},
    {"shear", shear},       {"elastic", elastic}, {"translation", translation},
    {"still", still_water}, {"meeting", meetings}};

/// The file's rows, those of the case replaced.
void replace(const std::string& path, const Rows& rows) {
  std::string kept = "case,resolution,time,measured,exact,error,seconds\n";
  std::ifstream old(path);
  for (std::string line; std::getline(old, line);)
    if (!line.starts_with("case,") && !line.starts_with(rows.name)) kept += line + "\n";
  old.close();
  std::ofstream(path) << kept << rows.text;
}

}  // namespace

int main(int count, char** words) {
  if (count < 3) {
    fmt::print(stderr, "fluid_validation FILE.csv CASE...; cases:");
    for (const auto& [name, run] : kCases) fmt::print(stderr, " {}", name);
    fmt::print(stderr, "\n");
    return 2;
  }
  for (int i = 2; i < count; ++i) {
    const auto found = kCases.find(words[i]);
    if (found == kCases.end()) {
      fmt::print(stderr, "no case is called {}\n", words[i]);
      return 2;
    }
    Rows rows{found->first, "", cpu_seconds()};
    found->second(rows);
    replace(words[1], rows);
  }
  return 0;
}
