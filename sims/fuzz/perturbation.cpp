// The same perturbation of the same positions gives the same bits again: corpus files rely on it.
#include "sims/fuzz/perturbation.h"

#include <cmath>
#include <limits>

#include "kernel/random.h"

namespace suture::sims {

namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

double neighbour(double x, Random& random) {
  return std::nextafter(x, random.below(2) == 0 ? -kInfinity : kInfinity);
}

void perturb_coordinates(std::vector<Point>& positions, const Perturbation& s,
                         const LatticePlanes& planes, Random& random) {
  const LatticePlanes halves{planes.cell / 2, planes.origin};
  for (Point& p : positions)
    for (int a = 0; a < 3; ++a) {
      if (random.uniform() >= s.share) continue;
      switch (s.how) {
        case Perturb::noise:
          p[a] += planes.cell * random.uniform(-s.amount, s.amount);
          break;
        case Perturb::snap:
          p[a] = planes.nearest(p[a], a);
          break;
        case Perturb::halve:
          p[a] = halves.nearest(p[a], a);
          break;
        case Perturb::nudge:
          p[a] = neighbour(planes.nearest(p[a], a), random);
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

double LatticePlanes::nearest(double x, int axis) const {
  return origin[axis] + std::round((x - origin[axis]) / cell) * cell;
}

void perturb(std::vector<Point>& positions, const Perturbation& s, const LatticePlanes& planes) {
  if (positions.empty()) return;
  Random random(s.seed);
  const int axis = static_cast<int>(random.below(3));
  Point by;
  for (int a = 0; a < 3; ++a) by[a] = planes.cell * random.uniform(-s.amount, s.amount);
  switch (s.how) {
    case Perturb::flatten:
      for (Point& p : positions)
        if (random.uniform() < s.share) p[axis] = planes.nearest(positions.front()[axis], axis);
      return;
    case Perturb::weld:
      return weld(positions, s.share, random);
    case Perturb::shear:
      for (Point& p : positions) p[0] += s.amount * p[2];
      return;
    case Perturb::translate:
      for (Point& p : positions) p += by;
      return;
    case Perturb::scale:
      for (Point& p : positions) p = planes.origin + s.amount * (p - planes.origin);
      return;
    default:
      return perturb_coordinates(positions, s, planes, random);
  }
}

}  // namespace suture::sims
