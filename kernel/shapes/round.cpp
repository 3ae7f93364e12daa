// Surfaces of revolution: torus, cylinder and dumbbell.
#include <algorithm>
#include <cmath>
#include <numbers>

#include "kernel/shapes/checks.h"
#include "kernel/shapes/rings.h"
#include "kernel/shapes/shapes.h"
#include "kernel/shapes/transform.h"

namespace suture {

namespace {

constexpr double kPi = std::numbers::pi;
const double kRow = std::sqrt(0.75);  // distance of rows, in edges, for equilateral triangles
constexpr int kNeckEdges = 8;         // at least so many go round a neck

int rows_along(double length, double edge_length, int least) {
  return std::max(least, static_cast<int>(std::round(length / (kRow * edge_length))));
}

// The upper half of a dumbbell's profile, from the middle of the neck outward to the pole.
class DumbbellProfile {
 public:
  explicit DumbbellProfile(const DumbbellParameters& p) : p_(p) {
    const double reach = p.radius + p.fillet, rise = p.neck_radius + p.fillet;
    const double aside = std::sqrt(reach * reach - rise * rise);
    fillet_at_ = p.distance / 2 - aside;
    turn_ = std::atan2(aside, rise);
    neck_step_ = std::min(p.edge_length, 2 * kPi * p.neck_radius / kNeckEdges);
  }
  double neck_half_length() const { return fillet_at_; }

  std::vector<Circle> circles() const {
    const double fillet = turn_ * p_.fillet, ball = (kPi / 2 + turn_) * p_.radius;
    std::vector<Circle> circles{circle_at(0)};
    double start = 0;
    for (const double length : {fillet_at_, fillet, ball}) {
      const auto step = [&](double s) { return kRow * edge(start + s, circle_at(start + s)); };
      const std::vector<double> ends = graded_steps(length, step);
      for (std::size_t i = 1; i < ends.size(); ++i) circles.push_back(circle_at(start + ends[i]));
      start += length;
    }
    circles.back() = {0, p_.distance / 2 + p_.radius, 1};
    return circles;
  }

 private:
  static constexpr double kGrowth = 0.25;  // of edges, in lengths per length away from the neck

  // The circle at the arc length s from the middle of the neck: on the neck, its fillet or the
  // ball.
  Circle circle_at(double s) const {
    Circle c;
    const double fillet = turn_ * p_.fillet;
    if (s <= fillet_at_) {
      c = {p_.neck_radius, s, 0};
    } else if (s <= fillet_at_ + fillet) {
      const double a = (s - fillet_at_) / p_.fillet;
      const double aside = p_.fillet * (1 - std::cos(a));
      c = {p_.neck_radius + aside, fillet_at_ + p_.fillet * std::sin(a), 0};
    } else {  // the angle is from the pole that faces the neck
      const double a = (s - fillet_at_ - fillet) / p_.radius + kPi / 2 - turn_;
      c = {p_.radius * std::sin(a), p_.distance / 2 - p_.radius * std::cos(a), 0};
    }
    c.count = edges_round(c.radius, edge(s, c));
    return c;
  }

  double edge(double s, const Circle& c) const {
    const double graded = neck_step_ + kGrowth * std::max(0.0, s - fillet_at_);
    const double edge = std::min(p_.edge_length, graded);
    return c.height > p_.distance / 2 ? edge : std::min(edge, 2 * kPi * c.radius / kNeckEdges);
  }

  const DumbbellParameters& p_;
  double fillet_at_ = 0, turn_ = 0, neck_step_ = 0;
};

}  // namespace

Triangles torus(const TorusParameters& p) {
  require_positive("torus: radius", p.radius);
  require_range("torus: tube_radius", p.tube_radius,
                {p.radius * 1e-3, p.radius * 0.95, "0.001 to 0.95 of its radius"});
  require_resolution("torus", 4 * kPi * kPi * p.radius * p.tube_radius, p.edge_length);
  const int rows = rows_along(2 * kPi * p.tube_radius, p.edge_length, 6);
  std::vector<Circle> circles;
  for (int k = 0; k < rows - rows % 2; ++k) {
    const double angle = 2 * kPi * k / (rows - rows % 2);
    const double radius = p.radius + p.tube_radius * std::cos(angle);
    circles.push_back(
        {radius, p.tube_radius * std::sin(angle), edges_round(radius, p.edge_length)});
  }
  return translated(revolved(circles, Profile::closed), p.centre);
}

Triangles cylinder(const CylinderParameters& p) {
  require_positive("cylinder: radius", p.radius);
  require_positive("cylinder: height", p.height);
  require_resolution("cylinder", 2 * kPi * p.radius * (p.radius + p.height), p.edge_length);
  const int cap = rows_along(p.radius, p.edge_length, 1);
  const int side = rows_along(p.height, p.edge_length, 1);
  std::vector<Circle> circles;
  const auto add = [&](double radius, double height) {
    circles.push_back({radius, height, edges_round(radius, p.edge_length)});
  };
  for (int k = 0; k <= cap; ++k) add(p.radius * k / cap, -p.height / 2);
  for (int k = 1; k < side; ++k) add(p.radius, p.height * (static_cast<double>(k) / side - 0.5));
  for (int k = cap; k >= 0; --k) add(p.radius * k / cap, p.height / 2);
  return translated(revolved(circles, Profile::from_axis_to_axis), p.centre);
}

Triangles dumbbell(const DumbbellParameters& p) {
  require_positive("dumbbell: radius", p.radius);
  require_range("dumbbell: neck_radius", p.neck_radius,
                {p.radius * 1e-3, p.radius * 0.95, "0.001 to 0.95 of its radius"});
  require_range("dumbbell: fillet", p.fillet,
                {p.radius * 1e-3, p.radius * 1e3, "0.001 to 1000 of its radius"});
  require_positive("dumbbell: distance", p.distance);
  require_resolution("dumbbell", 8 * kPi * p.radius * p.radius, p.edge_length);
  const DumbbellProfile profile(p);
  if (!(profile.neck_half_length() > 0))
    throw InvalidInput("dumbbell: a distance of " + number(p.distance) +
                       " leaves no neck between the fillets; choose a longer one, above " +
                       number(p.distance - 2 * profile.neck_half_length()));
  const std::vector<Circle> upper = profile.circles();
  std::vector<Circle> all;
  for (std::size_t k = upper.size(); k-- > 1;)
    all.push_back({upper[k].radius, -upper[k].height, upper[k].count});
  all.insert(all.end(), upper.begin(), upper.end());
  return translated(revolved(all, Profile::from_axis_to_axis), p.centre);
}

}  // namespace suture
