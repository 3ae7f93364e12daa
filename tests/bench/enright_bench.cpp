// What limits Enright's test with improvement: placement, resolution, time step, topology; as CSV.
#include <fmt/format.h>

#include <cmath>
#include <cstdio>
#include <ctime>
#include <numbers>

#include "kernel/measure/measures.h"
#include "kernel/shapes/shapes.h"
#include "sims/flows/fields.h"
#include "surgery/tracker.h"

using namespace suture;
using namespace suture::sims;

namespace {

constexpr double kRadius = 0.15, kPeriod = 3;
const Point kCentre(0.35, 0.35, 0.35);

double cpu_seconds() { return static_cast<double>(std::clock()) / CLOCKS_PER_SEC; }

struct Setting {
  const char* name;
  QualityOptions quality;
  double start_edge = 0.0078;
  int exact_volume = 1;
  double dt = 0.01;
  int improve_every = 5, remodel_every = 0;
  EnrightVariant variant = EnrightVariant::eltopo;
};

/// The place from which the flow brought x, by steps ten times shorter than any that is measured.
Point traced_back(Point x, const VelocityField& u, double t) {
  const int steps = static_cast<int>(std::ceil(t / 5e-3));
  const double dt = -t / steps;
  for (int i = 0; i < steps; ++i) {
    const double s = t + i * dt;
    const Point k1 = u(x, s), k2 = u(x + dt / 2 * k1, s + dt / 2);
    const Point k3 = u(x + dt / 2 * k2, s + dt / 2), k4 = u(x + dt * k3, s + dt);
    x += dt / 6 * (k1 + 2 * k2 + 2 * k3 + k4);
  }
  return x;
}

struct MarkerError {
  double mean = 0, max = 0;
};

/// How far vertices, traced back, are from the sphere that all of them should come from: of every
/// seventh.
MarkerError marker_error(const Triangles& s, const VelocityField& u, double t, double radius) {
  MarkerError error;
  std::size_t count = 0;
  for (std::size_t i = 0; i < s.positions.size(); i += 7, ++count) {
    const double d = std::abs((traced_back(s.positions[i], u, t) - kCentre).norm() - radius);
    error.mean += d;
    error.max = std::max(error.max, d);
  }
  error.mean /= static_cast<double>(count);
  return error;
}

/// Mean over the surface of the distance to the ball's, by 36 points of each triangle.
double mean_distance(const Triangles& s) {
  constexpr int kRows = 8;
  double sum = 0, area = 0;
  for (const Triangle& t : s.triangles) {
    const Point a = s.positions[t[0]] - kCentre, ab = s.positions[t[1]] - kCentre - a,
                ac = s.positions[t[2]] - kCentre - a;
    const double weight = ab.cross(ac).norm();
    double here = 0;
    for (int i = 0; i < kRows; ++i)
      for (int j = 0; i + j < kRows; ++j)
        here +=
            std::abs((a + (i + 1. / 3) / kRows * ab + (j + 1. / 3) / kRows * ac).norm() - kRadius);
    sum += weight * here / (kRows * (kRows + 1) / 2);
    area += weight;
  }
  return sum / area;
}

void run(const Setting& setting) {
  const Triangles start = sphere({.centre = kCentre,
                                  .radius = kRadius,
                                  .edge_length = setting.start_edge,
                                  .exact_volume = setting.exact_volume});
  const double radius = (start.positions[0] - kCentre).norm();
  const double ball = 4 * std::numbers::pi / 3 * kRadius * kRadius * kRadius;
  const VelocityField u = enright({setting.variant, kPeriod});
  Tracker tracker(start, {.cell_size = 0.01, .events = Events::merge, .quality = setting.quality});
  const int steps = static_cast<int>(std::lround(kPeriod / setting.dt));
  double triangles = 0, half_volume = 0;
  MarkerError half;
  std::size_t most = 0, cells = 0;
  double seconds = 0, from = cpu_seconds();
  for (int i = 1; i <= steps; ++i) {
    tracker.advect(u, setting.dt);
    if (setting.remodel_every > 0 && i % setting.remodel_every == 0)
      cells += tracker.remodel().marked.total();
    if (setting.improve_every > 0 && i % setting.improve_every == 0) tracker.improve();
    triangles += static_cast<double>(tracker.surface().triangles.size()) / steps;
    most = std::max(most, tracker.surface().triangles.size());
    if (2 * i != steps) continue;
    seconds += cpu_seconds() - from;
    half_volume = volume(tracker.surface()) / ball - 1;
    half = marker_error(tracker.surface(), u, i * setting.dt, radius);
    from = cpu_seconds();
  }
  seconds += cpu_seconds() - from;
  const MarkerError end = marker_error(tracker.surface(), u, kPeriod, radius);
  fmt::print("{},{},{},{:.0f},{},{},{:.4f},{:.2e},{:.2e},{:.4f},{:.2e},{:.2e},{:.2e},{:.1f}\n",
             setting.name, setting.dt, start.triangles.size(), triangles, most,
             tracker.surface().triangles.size(), 100 * half_volume, half.mean, half.max,
             100 * (volume(tracker.surface()) / ball - 1), end.mean, end.max,
             mean_distance(tracker.surface()), seconds);
  std::fflush(stdout);
  if (setting.remodel_every > 0)
    fmt::print(stderr, "{}: {} cells re-sampled\n", setting.name, cells);
}

/// The accuracy tables use this at about 25,000 triangles; `fine` multiplies all lengths.
QualityOptions tuned(double fine = 1) {
  return {.edge_length = 0.026 * fine,
          .chord_error = 5e-5 * fine * fine,
          .finest = 0.305,
          .shortest = 0.45,
          .keep_features = false,
          .subdivision = Subdivision::fitted};
}

QualityOptions uniform(Subdivision how) {
  return {.edge_length = 0.0105, .shortest = 0.45, .keep_features = false, .subdivision = how};
}

}  // namespace

int main() {
  fmt::print(
      "setting,dt,triangles_start,triangles_mean,triangles_max,triangles_end,"
      "half_volume_error_percent,half_marker_error_mean,half_marker_error_max,"
      "volume_error_percent,marker_error_mean,marker_error_max,mean_distance,cpu_seconds\n");
  const double fine = 0.5;
  for (const Setting& setting : std::initializer_list<Setting>{
           {"markers only", {}, 0.005, 1, 0.01, 0},
           {"markers only, four times as many", {}, 0.0025, 1, 0.01, 0},
           {"markers only, sixteen times as many", {}, 0.00125, 1, 0.01, 0},
           {"midpoints, uniform", uniform(Subdivision::midpoint)},
           {"curved, uniform", uniform(Subdivision::curved)},
           {"fitted, uniform", uniform(Subdivision::fitted)},
           {"fitted, by curvature", tuned()},
           {"the same, LeVeque's variant", tuned(1.075), 0.0081, 1, 0.01, 5, 0,
            EnrightVariant::leveque},
           {"the same, start inscribed", tuned(), 0.0078, 0},
           {"the same, improved at each step", tuned(), 0.0078, 1, 0.01, 1},
           {"the same, improved every tenth step", tuned(), 0.0078, 1, 0.01, 10},
           {"the same, twice the time step", tuned(), 0.0078, 1, 0.02, 3},
           {"the same, half the time step", tuned(), 0.0078, 1, 0.005, 10},
           {"the same, merges every fifth step", tuned(), 0.0078, 1, 0.01, 5, 5},
           {"the same, half the lengths", tuned(fine), 0.0039},
           {"the same, a third of the lengths", tuned(1 / 3.), 0.0026}})
    run(setting);
}
