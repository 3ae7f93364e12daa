// Planes are origin + i · cell rounded once, as the lattice has them: what is snapped lies on them.
#include "sims/fuzz/perturbation.h"

#include <cmath>
#include <limits>

#include "kernel/random.h"

namespace suture::sims {

namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

double plane_near(double x, double origin, double cell) {
  return origin + std::round((x - origin) / cell) * cell;
}

double neighbour(double x, Random& random) {
  return std::nextafter(x, random.below(2) == 0 ? -kInfinity : kInfinity);
}

void spoil_each(std::vector<Point>& positions, const Spoiling& s, double cell, const Point& origin,
                Random& random) {
  for (Point& p : positions)
    for (int a = 0; a < 3; ++a) {
      if (random.uniform() >= s.share) continue;
      switch (s.how) {
        case Spoil::noise:
          p[a] += cell * random.uniform(-s.amount, s.amount);
          break;
        case Spoil::snap:
          p[a] = plane_near(p[a], origin[a], cell);
          break;
        case Spoil::halve:
          p[a] = plane_near(p[a], origin[a], cell / 2);
          break;
        case Spoil::nudge:
          p[a] = neighbour(plane_near(p[a], origin[a], cell), random);
          break;
        default:
          p[a] = neighbour(p[a], random);
      }
    }
}

void weld(std::vector<Point>& positions, double share, Random& random) {
  for (Point& p : positions)
    if (random.uniform() < share) p = positions[random.below(positions.size())];
}

}  // namespace

void spoil(std::vector<Point>& positions, const Spoiling& s, double cell, const Point& origin) {
  if (positions.empty()) return;
  Random random(s.seed);
  const auto axis = static_cast<Eigen::Index>(random.below(3));
  Point by;
  for (int a = 0; a < 3; ++a) by[a] = cell * random.uniform(-s.amount, s.amount);
  switch (s.how) {
    case Spoil::flatten:
      for (Point& p : positions)
        if (random.uniform() < s.share)
          p[axis] = plane_near(positions.front()[axis], origin[axis], cell);
      return;
    case Spoil::weld:
      return weld(positions, s.share, random);
    case Spoil::shear:
      for (Point& p : positions) p[0] += s.amount * p[2];
      return;
    case Spoil::translate:
      for (Point& p : positions) p += by;
      return;
    case Spoil::scale:
      for (Point& p : positions) p = origin + s.amount * (p - origin);
      return;
    default:
      return spoil_each(positions, s, cell, origin, random);
  }
}

}  // namespace suture::sims
