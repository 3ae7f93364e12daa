// Velocity carried by itself from one grid to the next.
#include "sims/fluid/velocity/advect_velocity.h"

#include <algorithm>

#include "kernel/parallel.h"

namespace suture::sims {
namespace {

/// A face and where the path to it began.
struct Path {
  int axis;
  Slot face;
  Point start;
};

/// Calls visit(path) with each, on whichever thread: none looks at what another writes.
template <class Visit>
void for_each_path(std::vector<Path>& paths, Visit visit) {
  constexpr std::size_t kGrain = 4096;
  parallel_for(
      paths.size(), [&](std::size_t i) { visit(paths[i]); }, kGrain);
}

/// The second pass of Selle et al. takes off again half of what going there and back changes.
void correct(MacVelocity& now, const MacVelocity& old, std::vector<Path>& paths, double dt) {
  const MacVelocity there = now;
  for_each_path(paths, [&](const Path& path) {
    const auto& [axis, s, start] = path;
    const Index3 cell = now.grid->cell(s);
    const Slot before = old.grid->find(cell);
    if (before == kNoSlot || old.known[axis][before] == 0) return;
    const auto bounds = old.bounds(axis, start);
    if (!bounds.any) return;
    const double was = old.u[axis][before];
    const Point end = path_start(old, now.grid->face(cell, axis), -dt);
    const double back = there.component(axis, end, was);
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
  MacVelocity now(liquid.grid);
  std::vector<Path> paths;
  for_each_carried_face(liquid, [&](int axis, Slot s) {
    now.known[axis][s] = 1;
    paths.push_back({axis, s, Point::Zero()});
  });
  for_each_path(paths, [&](Path& path) {
    const Point p = liquid.grid->face(liquid.grid->cell(path.face), path.axis);
    path.start = path_start(old, p, dt);
    now.u[path.axis][path.face] = old.component(path.axis, path.start, old.component(path.axis, p));
  });
  if (scheme == VelocityAdvection::mac_cormack) correct(now, old, paths, dt);
  return now;
}

}  // namespace suture::sims
