// Animals and hands: the surfaces of smooth unions of tapered capsules [Figures 8, 10 and 12].
#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "kernel/isosurface/isosurface.h"
#include "kernel/shapes/checks.h"
#include "kernel/shapes/relax.h"
#include "kernel/shapes/shapes.h"

namespace suture {

namespace {

/// The balls along a segment whose radius goes from `from` to `to`.
struct Capsule {
  Point start, end;
  double from = 0, to = 0;
};

/// A function that is nearly the signed distance to capsules which flow into each other where they
/// are within `round` of each other.
class CapsuleUnion {
 public:
  struct Value {
    double value = 0;
    Point gradient = Point::Zero();
  };

  /// \pre there is a capsule, none without length; round > 0
  CapsuleUnion(std::vector<Capsule> capsules, double round)
      : capsules_(std::move(capsules)), round_(round) {}

  Value at(const Point& p) const;
  /// The point of the surface that Newton's method finds from p. \pre p is within half a cell of it
  Point onto_surface(Point p) const;

 private:
  std::vector<Capsule> capsules_;
  double round_;
};

/// The place of a union's surface, and its size in the scene.
struct SkinOptions {
  Box box;  ///< in the union's own unit; the surface reaches at most 0.06 out of it
  Point centre = Point::Zero();
  double length = 1;       ///< the union's unit in the scene's
  double edge_length = 0;  ///< in the scene's unit, as the centre is
};

using Value = CapsuleUnion::Value;

// The distance to the ball at the nearest point of the segment, which is nearly that to the
// capsule.
Value distance(const Capsule& c, const Point& p) {
  const Point along = c.end - c.start;
  const double length2 = along.squaredNorm(), at = (p - c.start).dot(along) / length2;
  const double t = std::clamp(at, 0.0, 1.0);
  const Point away = p - c.start - t * along;
  const double d = away.norm();
  Point gradient = away / std::max(d, 1e-300);
  if (t == at) gradient -= (c.to - c.from) / length2 * along;
  return {d - (c.from + t * (c.to - c.from)), gradient};
}

// The minimum, rounded where the two are within `width` of each other (Quilez's polynomial).
Value smooth_minimum(const Value& a, const Value& b, double width) {
  const Value &low = a.value < b.value ? a : b, &high = a.value < b.value ? b : a;
  const double h = std::max(width - (high.value - low.value), 0.0) / width;
  return {low.value - h * h * width / 4, low.gradient + h / 2 * (high.gradient - low.gradient)};
}

CapsuleUnion::Value CapsuleUnion::at(const Point& p) const {
  Value value = distance(capsules_[0], p);
  for (std::size_t i = 1; i < capsules_.size(); ++i)
    value = smooth_minimum(value, distance(capsules_[i], p), round_);
  return value;
}

Point CapsuleUnion::onto_surface(Point p) const {
  constexpr int kNewtonSteps = 4;  // they lead from half a cell away to the size of rounding
  for (int k = 0; k < kNewtonSteps; ++k) {
    const Value v = at(p);
    p -= v.value / v.gradient.squaredNorm() * v.gradient;
  }
  return p;
}

/// The surface of the union, closed and oriented, with edges of about edge_length, relaxed.
Triangles skin(const CapsuleUnion& capsules, const SkinOptions& options) {
  constexpr double kCellsPerEdge = 1.9;  // gives edges of edge_length on average, as measured
  constexpr double kLeastCosine = 0.3;   // between a triangle and the surface's normal
  const double cell = kCellsPerEdge * (options.edge_length / options.length);
  const Point margin = Point::Constant(0.06 + 2 * cell);
  Triangles surface = isosurface([&](const Point& q) { return capsules.at(q).value; },
                                 {options.box.low - margin, options.box.high + margin}, cell);
  relax(surface.positions, surface.triangles,
        {2, 15, [&](const Point& q) { return capsules.onto_surface(q); },
         [&](const Point& a, const Point& b, const Point& c) {
           const Point normal = (b - a).cross(c - a), up = capsules.at((a + b + c) / 3).gradient;
           return normal.dot(up) > kLeastCosine * normal.norm() * up.norm();
         }});
  for (Point& q : surface.positions) q = options.centre + options.length * q;
  return surface;
}

// All numbers are in lengths of the animal, and z is its left. Only the radius of its legs is free.
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

// All numbers are in lengths of the hand. Fingers point along x, the thumb to y, and the palm faces
// −z.
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

Triangles animal(const AnimalParameters& p) {
  require_positive("animal: length", p.length);
  require_range("animal: leg_radius", p.leg_radius, {0.02, 0.06, "0.02 to 0.06 of its length"});
  require_resolution("animal", 3 * p.length * p.length, p.edge_length);
  require_thin_edges("animal", p.edge_length, {"legs", p.leg_radius * p.length, 0.6});
  constexpr double kRound = 0.05;  // in lengths of the animal
  const Box box{Point(-0.8, -0.05, -0.25), Point(1.0, 1.3, 0.25)};
  return skin(CapsuleUnion(limbs(p.leg_radius), kRound), {box, p.centre, p.length, p.edge_length});
}

Triangles hand(const HandParameters& p) {
  constexpr double kRound = 0.04;  // in lengths of the hand
  require_positive("hand: length", p.length);
  require_range("hand: finger_radius", p.finger_radius,
                {0.025, 0.05, "0.025 to 0.05 of its length"});
  require_resolution("hand", 1.2 * p.length * p.length, p.edge_length);
  require_thin_edges("hand", p.edge_length, {"fingers", p.finger_radius * p.length, 0.45});
  const Box box{Point(-0.42, -0.3, -0.16), Point(1.04, 0.44, 0.13)};
  return skin(CapsuleUnion(bones(p.finger_radius), kRound),
              {box, p.centre, p.length, p.edge_length});
}

}  // namespace suture
