// Surgery's tests share these: pipelines up to a stage, slow twins, and bodies to operate on.
#pragma once

#include <memory>
#include <numbers>

#include "kernel/audit.h"
#include "kernel/measure/measures.h"
#include "kernel/random.h"
#include "kernel/shapes/shapes.h"
#include "kernel/shapes/transform.h"
#include "surgery/detect/complex_cells.h"
#include "surgery/tracker.h"

namespace suture {

using namespace suture::surgery;

/// Crossings and windings of a surface on the lattice that a tracker would use.
struct Scan {
  Incidence mesh;
  Lattice lattice;
  std::unique_ptr<Oracle> oracle;
  Crossings crossings;
  Winding winding;

  ShiftedLattice on() const { return {lattice, *oracle}; }
};

inline Scan scan(const Triangles& surface, double cell,
                 Arithmetic arithmetic = Arithmetic::filtered) {
  Incidence mesh = incidence(surface);
  Lattice lattice = lattice_around(bounding_box(surface.positions), cell, Point::Zero(), 4);
  auto oracle = make_oracle(arithmetic);
  Crossings crossings = find_crossings(mesh, {lattice, *oracle});
  Winding winding(crossings);
  return {std::move(mesh), std::move(lattice), std::move(oracle), std::move(crossings),
          std::move(winding)};
}

/// Solid angle of the surface at a point over 4π: the winding number there, where it is not on it.
inline double solid_angle_winding(const Triangles& surface, const Point& at) {
  double sum = 0;
  for (const Triangle& t : surface.triangles) {
    const Point a = surface.positions[t[0]] - at, b = surface.positions[t[1]] - at,
                c = surface.positions[t[2]] - at;
    const double la = a.norm(), lb = b.norm(), lc = c.norm();
    sum += 2 * std::atan2(a.dot(b.cross(c)),
                          la * lb * lc + a.dot(b) * lc + b.dot(c) * la + c.dot(a) * lb);
  }
  return sum / (4 * std::numbers::pi);
}

inline Triangles ball(double radius, const Point& centre = Point::Zero(), int frequency = 12) {
  return sphere({centre, radius, 0.1, frequency});
}

inline Triangles together(const Triangles& a, const Triangles& b) {
  return merged(std::vector<Triangles>{a, b});
}

/// A ball whose vertices are moved by up to its radius: self-intersecting and partly inverted.
inline Triangles tangle(std::uint64_t seed) {
  Random random(seed);
  Triangles body = ball(1, Point::Zero(), 4);
  for (Point& p : body.positions)
    p += Point{random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(-1, 1)};
  return body;
}

}  // namespace suture
