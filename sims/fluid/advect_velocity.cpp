// Velocity carried by itself from one grid to the next.
#include "sims/fluid/advect_velocity.h"

#include <algorithm>

namespace suture {
namespace {

/// A face and where the path to it began.
struct Path {
  int axis;
  Slot face;
  Point start;
};

/// Selle et al.'s second pass: half of what going there and back changes is taken off again.
void correct(MacVelocity& now, const MacVelocity& old, const std::vector<Path>& paths, double dt) {
  const MacVelocity there = now;
  for (const auto& [axis, s, start] : paths) {
    const Index3 cell = now.grid->cell(s);
    const Slot before = old.grid->find(cell);
    if (before == kNoSlot || old.known[axis][before] == 0) continue;
    const auto bounds = old.bounds(axis, start);
    if (!bounds.any) continue;
    const double was = old.u[axis][before];
    const Point end = path_start(old, now.grid->face(cell, axis), -dt);
    const double back = there.component(axis, end, was);
    now.u[axis][s] = std::clamp(there.u[axis][s] + 0.5 * (was - back), bounds.low, bounds.high);
  }
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
  std::vector<Path> paths;
  const bool corrects = scheme == VelocityAdvection::mac_cormack;
  for_each_carried_face(liquid, [&](int axis, Slot s) {
    const Point p = liquid.grid->face(liquid.grid->cell(s), axis);
    const Point start = path_start(old, p, dt);
    now.u[axis][s] = old.component(axis, start, old.component(axis, p));
    now.known[axis][s] = 1;
    if (corrects) paths.push_back({axis, s, start});
  });
  if (corrects) correct(now, old, paths, dt);
  return now;
}

}  // namespace suture
