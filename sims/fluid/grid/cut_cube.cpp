// The part of a cube on one side of a plane: how much of a cell is liquid.
#include "sims/fluid/grid/cut_cube.h"

#include <algorithm>
#include <cmath>

namespace suture::sims {
namespace {

/// Below the plane m·x = a of the unit cube with a corner at the origin; 0 <= m sorted, sum 1.
double volume_below(const std::array<double, 3>& m, double a) {
  if (a > 0.5) return 1 - volume_below(m, 1 - a);
  if (!(a > 0)) return 0;
  const double m12 = m[0] + m[1], six = 6 * m[0] * m[1] * m[2];
  const auto corner = [&](int i) { return m[i] * m[i] * (m[i] - 3 * a); };
  if (a < m[0]) return a * a * a / six;
  const double first = m[0] > 0 ? m[0] * m[0] / (6 * m[1] * m[2]) : 0;
  const auto second = [&](double x) { return x * (x - m[0]) / (2 * m[1] * m[2]) + first; };
  if (a < m[1]) return second(a);
  if (a >= m12 && m12 <= m[2]) return (2 * a - m12) / (2 * m[2]);
  // Where the least component is small the next formula cancels, and its range is as short.
  const double low = m[1] > 0 ? second(m[1]) : 0;
  const double high = m12 <= m[2] ? m12 / (2 * m[2]) : 0.5;
  if (!(six > 0)) return low;
  const double x = a < m[2] ? a * a * (3 * m12 - a) + corner(0) + corner(1)
                            : a * a * (3 - 2 * a) + corner(0) + corner(1) + corner(2);
  return std::clamp(x / six, low, high);
}

/// A plane as volume_below takes it.
struct Sorted {
  std::array<double, 3> m;
  double sum;

  explicit Sorted(const Point& normal)
      : m{std::abs(normal[0]), std::abs(normal[1]), std::abs(normal[2])} {
    std::sort(m.begin(), m.end());
    sum = m[0] + m[1] + m[2];
    for (double& x : m) x /= sum;
  }
  double below(double s) const { return volume_below(m, s / sum + 0.5); }
};

}  // namespace

double cut_volume(const Point& normal, double s) { return Sorted(normal).below(s); }

CutCube cut_cube(const Point& normal, double s) {
  const Sorted plane(normal);
  const double half = plane.sum / 2;
  const auto below = [&](double t) { return plane.below(t); };
  CutCube cut{below(s), 0};
  if (!(cut.volume > 0) || s >= half) return cut;
  // The moment is s·V(s) less the integral of V, which is smooth: Simpson's rule will do.
  constexpr int steps = 16;
  const double step = (s + half) / steps;
  double integral = 0;
  for (int i = 0; i <= steps; ++i)
    integral += below(-half + i * step) * (i == 0 || i == steps ? 1 : i % 2 == 1 ? 4 : 2);
  cut.offset = s - integral * step / 3 / cut.volume;
  return cut;
}

}  // namespace suture::sims
