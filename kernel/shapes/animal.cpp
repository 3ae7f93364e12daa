// A four-legged animal with thin legs: a smooth union of tapered capsules [Figures 8 and 12].
#include "kernel/shapes/capsules.h"
#include "kernel/shapes/checks.h"
#include "kernel/shapes/shapes.h"

namespace suture {

namespace {

// All in lengths of the animal; z is its left. The legs' radius is the only free one.
std::vector<Capsule> limbs(double leg) {
  std::vector<Capsule> all{{{-0.40, 0.68, 0}, {0.36, 0.66, 0}, 0.185, 0.195},  // trunk
                           {{0.42, 0.74, 0}, {0.66, 1.04, 0}, 0.13, 0.085},    // neck
                           {{0.68, 1.08, 0}, {0.93, 0.97, 0}, 0.092, 0.055},   // head
                           {{-0.54, 0.76, 0}, {-0.68, 0.64, 0}, 0.05, 0.042},  // tail
                           {{-0.68, 0.64, 0}, {-0.74, 0.36, 0}, 0.042, 0.036}};
  for (const double side : {-1.0, 1.0}) {
    const double z = side * 0.115;
    const auto add = [&](const Point& a, const Point& b, double from, double to) {
      all.push_back({{a[0], a[1], side * a[2]}, {b[0], b[1], side * b[2]}, from, to});
    };
    all.push_back({{0.65, 1.12, side * 0.05}, {0.62, 1.22, side * 0.075}, 0.036, 0.03});  // ear
    add({0.37, 0.58, 0.1}, {0.39, 0.31, 0.115}, 0.09, 1.15 * leg);
    add({-0.44, 0.60, 0.1}, {-0.50, 0.32, 0.115}, 0.11, 1.2 * leg);
    all.push_back({{0.39, 0.31, z}, {0.37, 0.04, z}, 1.15 * leg, leg});
    all.push_back({{-0.50, 0.32, z}, {-0.46, 0.04, z}, 1.2 * leg, leg});
    all.push_back({{0.37, 0.04, z}, {0.40, 0.035, z}, 1.15 * leg, 1.1 * leg});  // hooves
    all.push_back({{-0.46, 0.04, z}, {-0.43, 0.035, z}, 1.15 * leg, 1.1 * leg});
  }
  return all;
}

}  // namespace

Triangles animal(const AnimalParameters& p) {
  require_positive("animal: length", p.length);
  require_range("animal: leg_radius", p.leg_radius, 0.02, 0.06, "0.02 to 0.06 of its length");
  require_resolution("animal", 3 * p.length * p.length, p.edge_length);
  require_thin_edges("animal", p.edge_length, {"legs", p.leg_radius * p.length, 0.6});
  constexpr double kRound = 0.05;  // lengths; how far limbs flow into each other
  const Box box{Point(-0.8, -0.05, -0.25), Point(1.0, 1.3, 0.25)};
  return skin(CapsuleUnion(limbs(p.leg_radius), kRound), {box, p.centre, p.length, p.edge_length});
}

}  // namespace suture
