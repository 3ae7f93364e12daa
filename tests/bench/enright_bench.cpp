// What limits Enright's test with improvement: volume and distance at T/2 and T, by settings.
#include <CLI/CLI.hpp>
#include <cmath>
#include <ctime>

#include <fmt/format.h>

#include "kernel/measures.h"
#include "kernel/self_intersections.h"
#include "kernel/mesh_io.h"
#include "kernel/shapes.h"
#include "sims/flows/fields.h"


using namespace suture;
double now_time = 0;

namespace {
const Point kCentre(0.35, 0.35, 0.35);
double seconds() { return static_cast<double>(std::clock()) / CLOCKS_PER_SEC; }

Point back(Point x, const VelocityField& u, double t) {
  const int n = 300;
  const double dt = -t / n;
  for (int i = 0; i < n; ++i) {
    const double s = t + i * dt;
    const Point k1 = u(x, s), k2 = u(x + dt / 2 * k1, s + dt / 2), k3 = u(x + dt / 2 * k2, s + dt / 2),
                k4 = u(x + dt * k3, s + dt);
    x += dt / 6 * (k1 + 2 * k2 + 2 * k3 + k4);
  }
  return x;
}

/// Mean and largest distance of vertices, carried back, from the sphere.
void marker_error(const Triangles& s, const VelocityField& u, double t, double r, double& mean, double& most) {
  mean = most = 0;
  std::size_t n = 0;
  std::vector<double> all;
  for (std::size_t i = 0; i < s.positions.size(); i += 7) {
    const double d = std::abs((back(s.positions[i], u, t) - kCentre).norm() - r);
    mean += d;
    all.push_back(d);
    most = std::max(most, d);
    ++n;
  }
  mean /= static_cast<double>(n);
  std::sort(all.begin(), all.end());
  fmt::print("  quantiles 50 {:.1e} 75 {:.1e} 90 {:.1e} 95 {:.1e} 99 {:.1e}\n", all[n/2], all[n*3/4], all[n*9/10], all[n*95/100], all[n*99/100]);
}

/// Mean over the area of | |x| − r |, by points of each triangle.
double mean_distance(const Triangles& s, double r) {
  double sum = 0, area = 0;
  const int n = 8;
  for (const Triangle& t : s.triangles) {
    const Point a = s.positions[t[0]] - kCentre, b = s.positions[t[1]] - kCentre, c = s.positions[t[2]] - kCentre;
    const double w = (b - a).cross(c - a).norm() / 2;
    double here = 0;
    int count = 0;
    for (int i = 0; i < n; ++i)
      for (int j = 0; i + j < n; ++j) {
        const double x = (i + 1. / 3) / n, y = (j + 1. / 3) / n;
        here += std::abs((a + x * (b - a) + y * (c - a)).norm() - r);
        ++count;
      }
    sum += w * here / count;
    area += w;
  }
  return sum / area;
}
}  // namespace

int main(int argc, char** argv) {
  CLI::App app;
  TrackerOptions o;
  QualityOptions& q = o.quality;
  q.edge_length = 0.01;
  double start = 0.01, dt = 0.01, radius = 0.15;
  int every = 1;
  bool leveque = false, volume_radius = false;
  std::string sub = "curved", save;
  int often = 0;
  bool trace = false;
  app.add_flag("--trace", trace);
  app.add_option("--often", often);
  app.add_option("--start", start);
  app.add_option("--dt", dt);
  app.add_option("--every", every);
  app.add_option("--edge", q.edge_length);
  app.add_option("--longest", q.longest);
  app.add_option("--shortest", q.shortest);
  app.add_option("--angle", q.smallest_angle);
  app.add_option("--large", q.largest_angle);
  app.add_option("--volume", q.volume_bound);
  app.add_option("--passes", q.passes);
  app.add_option("--sub", sub);
  app.add_option("--save", save);
  app.add_flag("--leveque", leveque);
  app.add_flag("--exact-volume", volume_radius);
  app.add_flag("--no-features{false}", q.keep_features);
  app.add_option("--chord", q.chord_error);
  app.add_option("--finest", q.finest);
  CLI11_PARSE(app, argc, argv);
  q.subdivision = sub == "curved" ? Subdivision::curved : sub == "midpoint" ? Subdivision::midpoint : Subdivision::fitted;
  o.cell_size = 0.01;
  const double exact = 4 * M_PI / 3 * 0.15 * 0.15 * 0.15;
  Triangles s = sphere({kCentre, radius, start});
  if (volume_radius) {
    radius *= std::cbrt(exact / volume(s));
    s = sphere({kCentre, radius, start});
  }
  const double v0 = volume(s);
  const VelocityField u = enright({leveque ? EnrightVariant::leveque : EnrightVariant::eltopo, 3});
  Tracker tracker(s, o);
  const int steps = static_cast<int>(std::lround(3 / dt));
  double triangles = 0, improving = 0, total = seconds();
  std::size_t most = 0, n0 = s.triangles.size();
  std::size_t subd = 0, coll = 0, flips = 0, flat = 0;
  double least_angle = 90;
  for (int i = 1; i <= steps; ++i) {
    tracker.advect(u, dt);
    if (every > 0 && (i % every == 0 || i == steps)) {
      now_time = i * dt;
      const double t0 = seconds();
      const QualityReport r = tracker.improve();
      improving += seconds() - t0;
      if (trace) {
        const Triangles& now = tracker.surface();
        std::vector<char> old(now.positions.size(), 0);
        for (auto v : r.vertex_map) if (v != kNone) old[v] = 1;
        std::vector<double> turn(now.positions.size(), 1), shortest(now.positions.size(), 1e9), longest(now.positions.size(), 0);
        std::vector<Point> normal(now.positions.size(), Point::Zero());
        for (auto& f : now.triangles) { Point m = (now.positions[f[1]]-now.positions[f[0]]).cross(now.positions[f[2]]-now.positions[f[0]]); for (auto v : f) normal[v] += m; }
        for (auto& f : now.triangles) { Point m = (now.positions[f[1]]-now.positions[f[0]]).cross(now.positions[f[2]]-now.positions[f[0]]); for (int k=0;k<3;++k) { auto v=f[k]; turn[v] = std::min(turn[v], m.normalized().dot(normal[v].normalized()));
          for (int l : {(k+1)%3,(k+2)%3}) { double d=(now.positions[f[l]]-now.positions[v]).norm(); shortest[v]=std::min(shortest[v],d); longest[v]=std::max(longest[v],d);} } }
        for (std::size_t v = 0; v < old.size(); ++v) if (!old[v]) {
          double d = std::abs((back(now.positions[v], u, i * dt) - kCentre).norm() - radius);
          if (d > 2e-5) fmt::print("NEW t {:.2f} err {:.2e} turn {:.0f} edges {:.4f} {:.4f} at {:.3f} {:.3f} {:.3f} material {:.3f} {:.3f} {:.3f} signed {:.1e}\n", i*dt, d, std::acos(std::clamp(turn[v],-1.,1.))*57.3, shortest[v], longest[v], now.positions[v][0], now.positions[v][1], now.positions[v][2], ((back(now.positions[v], u, i * dt) - kCentre)/radius)[0],((back(now.positions[v], u, i * dt) - kCentre)/radius)[1],((back(now.positions[v], u, i * dt) - kCentre)/radius)[2], (back(now.positions[v], u, i * dt) - kCentre).norm() - radius);
        }
      }
      subd += r.subdivisions; coll += r.collapses.done; flips += r.flips; flat += r.flattened;
      least_angle = std::min(least_angle, r.smallest_angle);
    }
    triangles += static_cast<double>(tracker.surface().triangles.size()) / steps;
    most = std::max(most, tracker.surface().triangles.size());
    if (i == steps / 2 || i == steps || (often > 0 && i % often == 0)) {
      const double v = volume(tracker.surface());
      double mean = 0, worst = 0;
      const double t0 = seconds();
      marker_error(tracker.surface(), u, i * dt, radius, mean, worst);
      total += seconds() - t0;
      fmt::print("  t {:.2f}: n {} vol/start {:+.4f} % vol/exact {:+.4f} % markers mean {:.2e} max {:.2e} angle {:.1f} sub {} coll {} flip {} flat {}",
                 i * dt, tracker.surface().triangles.size(), 100 * (v / v0 - 1), 100 * (v / exact - 1), mean, worst, least_angle, subd, coll, flips, flat);
      if (i == steps) fmt::print(" mean distance {:.2e}", mean_distance(tracker.surface(), 0.15));
      fmt::print("\n");
      if (!save.empty()) write_triangles(fmt::format("{}_{}.ply", save, i), tracker.surface());
    }
  }
  total = seconds() - total;
  fmt::print("{} -> avg {:.0f} max {}; {:.1f} s, improving {:.1f} s\n", n0, triangles, most, total, improving);
}
