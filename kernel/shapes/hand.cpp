// A hand with its fingers spread: a smooth union of tapered capsules [Figure 10].
#include "kernel/shapes/capsules.h"
#include "kernel/shapes/checks.h"
#include "kernel/shapes/shapes.h"

namespace suture {
namespace {

// All in lengths of the hand; fingers point along x, the thumb to y, the palm faces −z.
std::vector<Capsule> bones(double finger) {
  std::vector<Capsule> all{{{-0.30, 0, 0}, {0.02, 0, 0}, 0.105, 0.09}};  // forearm and wrist
  const auto add = [&](const Point& a, const Point& b, double from, double to) {
    all.push_back({a, b, from, to});
  };
  struct Finger {
    double knuckle_x, knuckle_y, tip_x, tip_y, width;
  };
  constexpr Finger fingers[] = {{0.44, 0.135, 0.86, 0.225, 0.95},    // index
                                {0.47, 0.045, 0.98, 0.065, 1.0},     // middle
                                {0.44, -0.045, 0.90, -0.085, 0.95},  // ring
                                {0.39, -0.13, 0.74, -0.235, 0.8}};   // little
  for (const Finger& f : fingers) {
    const double r = finger * f.width;
    const Point knuckle(f.knuckle_x, f.knuckle_y, 0.015), tip(f.tip_x, f.tip_y, -0.05);
    const Point middle = knuckle + 0.52 * (tip - knuckle) + Point(0, 0, 0.025);
    add({0.04, 0.3 * f.knuckle_y, 0}, knuckle, 0.075, 1.35 * r);  // in the palm
    add(knuckle, middle, 1.2 * r, 1.05 * r);
    add(middle, tip, 1.05 * r, 0.8 * r);
  }
  add({0.06, 0.06, -0.01}, {0.24, 0.20, -0.04}, 0.085, 1.35 * finger);  // thumb
  add({0.24, 0.20, -0.04}, {0.38, 0.31, -0.07}, 1.3 * finger, 1.15 * finger);
  add({0.38, 0.31, -0.07}, {0.50, 0.37, -0.09}, 1.15 * finger, 0.9 * finger);
  return all;
}

}  // namespace

Triangles hand(const HandParameters& p) {
  constexpr double kRound = 0.04;  // lengths; how far bones flow into each other
  require_positive("hand: length", p.length);
  require_range("hand: finger_radius", p.finger_radius, 0.025, 0.05, "0.025 to 0.05 of its length");
  require_resolution("hand", 1.2 * p.length * p.length, p.edge_length);
  require_thin_edges("hand", p.edge_length, {"fingers", p.finger_radius * p.length, 0.45});
  const Box box{Point(-0.42, -0.3, -0.16), Point(1.04, 0.44, 0.13)};
  return skin(CapsuleUnion(bones(p.finger_radius), kRound),
              {box, p.centre, p.length, p.edge_length});
}

}  // namespace suture
