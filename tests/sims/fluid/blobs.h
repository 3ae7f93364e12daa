// Liquid and solids of a formula on a grid of their own, for the tests of what acts on velocity.
#pragma once

#include <algorithm>
#include <cmath>
#include <functional>
#include <memory>

#include "sims/fluid/grid/mac_velocity.h"
#include "sims/fluid/liquid/liquid.h"
#include "sims/fluid/liquid/volume_fractions.h"
#include "sims/fluid/solids/solids.h"

namespace suture {

using namespace suture::sims;

using Formula = std::function<double(const Point&)>;
using FlowFormula = std::function<Point(const Point&)>;

/// A grid over the cube of `half` cells each way from 0, where D is the formula's.
struct Blob {
  SharedGrid grid;
  Liquid liquid;
  SolidFaces solids;

  Blob(int half, double h, const Formula& distance) {
    std::vector<Index3> cells;
    for (int i = -half; i < half; ++i)
      for (int j = -half; j < half; ++j)
        for (int k = -half; k < half; ++k) cells.push_back({i, j, k});
    grid = liquid.grid = shared_grid(Point::Zero(), h, cells);
    for (Slot s = 0; s < grid->size(); ++s)
      liquid.distance.push_back(
          std::clamp(distance(grid->centre(grid->cell(s))), -kFar * h, kFar * h));
  }

  /// Solids where the distance is negative, which all move as `flow`.
  void add_solids(const Formula& distance, const FlowFormula& flow) {
    constexpr int samples = 16;
    for (int a = 0; a < 3; ++a)
      for (Slot s = 0; s < grid->size(); ++s) {
        const Point middle = grid->face(grid->cell(s), a);
        const bool cut = std::abs(distance(middle)) < grid->h();
        double open = !cut && distance(middle) > 0 ? 1 : 0;
        for (int n = 0; cut && n < samples * samples; ++n) {
          Point p = middle;
          p[next_axis(a)] += grid->h() * ((n % samples + 0.5) / samples - 0.5);
          p[prev_axis(a)] += grid->h() * ((n / samples + 0.5) / samples - 0.5);
          if (distance(p) > 0) open += 1.0 / (samples * samples);
        }
        solids.open[a].push_back(open);
        solids.velocity[a].push_back(flow(middle)[a]);
      }
  }

  MacVelocity velocity(const FlowFormula& flow) const {
    MacVelocity v(grid);
    for (int a = 0; a < 3; ++a)
      for (Slot s = 0; s < grid->size(); ++s) {
        v.u[a][s] = flow(grid->face(grid->cell(s), a))[a];
        v.known[a][s] = 1;
      }
    return v;
  }
};

/// Sums over the faces' fractions of liquid that solids leave open.
struct Moments {
  double mass = 0, energy = 0;
  Point momentum = Point::Zero(), spin = Point::Zero();
};
inline Moments moments(const MacVelocity& v, const VolumeFractions& fractions,
                       const SolidFaces& solids = {}) {
  Moments m;
  for (int a = 0; a < 3; ++a)
    for (Slot s = 0; s < v.grid->size(); ++s) {
      const double w = fractions.face[a][s] * solids.open_at(a, s);
      if (w == 0) continue;
      Point u = Point::Zero();
      u[a] = v.u[a][s];
      m.mass += w / 3;
      m.energy += w * u.squaredNorm() / 2;
      m.momentum += w * u;
      m.spin += w * v.grid->face(v.grid->cell(s), a).cross(u);
    }
  return m;
}

/// The part of `mode` in v, by the faces' fractions of liquid that solids leave open.
inline double part_of(const MacVelocity& v, const MacVelocity& mode,
                      const VolumeFractions& fractions, const SolidFaces& solids = {}) {
  double sum = 0, all = 0;
  for (int a = 0; a < 3; ++a)
    for (Slot s = 0; s < v.grid->size(); ++s) {
      const double w = fractions.face[a][s] * solids.open_at(a, s);
      if (w == 0) continue;
      sum += w * v.u[a][s] * mode.u[a][s];
      all += w * mode.u[a][s] * mode.u[a][s];
    }
  return sum / all;
}

/// Root of the mean over the liquid's mass of the squared difference.
inline double difference(const MacVelocity& v, const MacVelocity& other,
                         const VolumeFractions& fractions, const SolidFaces& solids = {}) {
  double sum = 0, mass = 0;
  for (int a = 0; a < 3; ++a)
    for (Slot s = 0; s < v.grid->size(); ++s) {
      const double w = fractions.face[a][s] * solids.open_at(a, s);
      if (w == 0) continue;
      sum += w * std::pow(v.u[a][s] - other.u[a][s], 2);
      mass += w / 3;
    }
  return std::sqrt(sum / mass);
}

/// Spherical Bessel function of order 1.
inline double bessel(double x) {
  return std::abs(x) < 1e-3 ? x / 3 : std::sin(x) / (x * x) - std::cos(x) / x;
}

/// Turning about the axis through 0, each sphere by another angle: without divergence, and in a
/// viscous or an elastic ball of the right size a mode of its own.
inline FlowFormula torsion(double k) {
  const Point axis = Point(1, 2, 3).normalized();
  return [k, axis](const Point& p) -> Point {
    const double r = p.norm();
    return axis.cross(p) * (k * r < 1e-3 ? k / 3 : bessel(k * r) / r);
  };
}

}  // namespace suture
