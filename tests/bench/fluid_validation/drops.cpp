// Drops under tension: how fast they swing [Lamb 1932, §275], and what stirs them at rest.
#include <cmath>

#include "tests/bench/fluid_validation/validation.h"
#include "tests/sims/fluid/runs.h"

namespace suture {

using namespace suture::sims;
namespace {

constexpr double kBend = 0.01;  // so little that what is of second order in it does not count

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

Triangles bent(double radius, double edge) {
  Triangles start = sphere({Point::Zero(), radius, edge, 0, 1});
  for (Point& p : start.positions) {
    const double z = p.normalized()[2];
    p *= 1 + kBend * (1.5 * z * z - 0.5);
  }
  return translated(start, kDropCentre);
}

/// The period is four times the way to the first zero, and twice what is between the first and the
/// second. A further row has what is left of the amplitude where the drop turns.
void swing(Rows& rows, double radius, double edge, std::size_t most_zeros) {
  const Triangles start = bent(radius, edge);
  Run run(start, edge, drop_options(), at_rest, kMarkers);
  const double period = drop_period(radius), whole = bend(start, radius);
  const int steps = run.fluid.steps_in(period);
  double before = whole, turned = 0;
  std::vector<double> zeros;
  rows.add("_bend", radius, 0, 1, 1);
  for (int i = 1; i <= steps && zeros.size() < most_zeros; ++i) {
    run.fluid.step(*run.surface, period / steps);
    run.surface->improve();
    const double now = bend(run.surface->surface(), radius);
    if (before * now < 0) zeros.push_back((i - now / (now - before)) / steps * period);
    if (i % std::max(1, steps / 40) == 0 || zeros.size() == most_zeros)
      rows.add("_bend", radius, 1.0 * i / steps, now / whole,
               std::cos(2 * std::numbers::pi * i / steps));
    turned = std::min(turned, now);
    before = now;
  }
  if (!zeros.empty()) rows.add("_quarter", radius, zeros[0], 4 * zeros[0], period);
  if (zeros.size() < 2) return;
  rows.add("_period", radius, zeros[1], 2 * (zeros[1] - zeros[0]), period);
  rows.add("_turned", radius, period / 2, -turned / whole, 1);
}

}  // namespace

void drops(Rows& rows) {
  for (const double radius : {4.0, 6.0, 8.0, 12.0, 16.0}) {
    rows.restart();
    swing(rows, radius, 0.9, 2);
  }
}

/// The finest, which takes longer than all else: to its first zero.
void fine_drop(Rows& rows) { swing(rows, 32, 0.9, 1); }

/// A remodelled, irregular mesh of a ball at rest, for half a period.
void currents(Rows& rows) {
  for (const double radius : {4.0, 6.0, 8.0, 12.0, 16.0}) {
    rows.restart();
    const double time = drop_period(radius) / 2, speed = std::sqrt(1 / radius);
    Run run(remodelled(radius, 0.8), 0.8, drop_options(), at_rest, kMarkers);
    const int steps = run.fluid.steps_in(time);
    double most = 0;
    for (int i = 0; i < steps; ++i) {
      run.fluid.step(*run.surface, time / steps);
      run.surface->improve();
      most = std::max(most, run.fastest());
    }
    rows.add("_most", radius, time, most / speed, 0);
    rows.add("_end", radius, time, run.fastest() / speed, 0);
  }
}

}  // namespace suture
