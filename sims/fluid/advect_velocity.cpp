// Velocity carried by itself from one grid to the next.
#include "sims/fluid/advect_velocity.h"

#include <algorithm>

namespace suture {
namespace {

/// Selle et al.'s second pass: half of what going there and back changes is taken off again.
void correct(MacVelocity& now, const MacVelocity& old, const Liquid& liquid, double dt) {
  const MacVelocity there = now;
  for_each_carried_face(liquid, [&](int axis, Slot s) {
    if (there.known[axis][s] == 0) return;
    const Index3 cell = liquid.grid->cell(s);
    const Slot before = old.grid->find(cell);
    if (before == kNoSlot || old.known[axis][before] == 0) return;
    const Point p = liquid.grid->face(cell, axis);
    const auto bounds = old.bounds(axis, path_start(old, p, dt));
    if (!bounds.any) return;
    const double was = old.u[axis][before];
    const double back = there.component(axis, path_start(old, p, -dt), was);
    now.u[axis][s] = std::clamp(there.u[axis][s] + 0.5 * (was - back), bounds.low, bounds.high);
  });
}

}  // namespace

Point path_start(const MacVelocity& u, const Point& p, double dt) {
  const Point a = u.at(p);
  const Point b = u.at(p - 0.5 * dt * a, a);
  const Point c = u.at(p - 0.75 * dt * b, b);
  return p - dt * (2.0 / 9 * a + 3.0 / 9 * b + 4.0 / 9 * c);
}

MacVelocity carried(const MacVelocity& old, const Liquid& liquid, double dt,
                    VelocityAdvection scheme) {
  MacVelocity now(*liquid.grid);
  for_each_carried_face(liquid, [&](int axis, Slot s) {
    const Point p = liquid.grid->face(liquid.grid->cell(s), axis);
    const double here = old.component(axis, p);
    now.u[axis][s] = old.component(axis, path_start(old, p, dt), here);
    now.known[axis][s] = 1;
  });
  if (scheme == VelocityAdvection::mac_cormack) correct(now, old, liquid, dt);
  return now;
}

}  // namespace suture
