// A ball carved with deep ornament: steep-walled grooves pressed radially into a sphere [Figure 1].
#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numbers>

#include "kernel/random.h"
#include "kernel/shapes/checks.h"
#include "kernel/shapes/relax.h"
#include "kernel/shapes/shapes.h"

namespace suture {

namespace {

constexpr double kPi = std::numbers::pi;
constexpr int kSweeps = 12;  // raises the angles on the walls; later ones change little

// A flower of grooves about a direction has a wavy ring inside a round one, and a pit in the
// middle.
struct Rosette {
  Point axis, start, side;
  int petals = 0;
  double wave = 0, phase = 0;
};

// The depth of the ornament in each direction. It has rosettes on the corners of a turned
// icosahedron, and grooves half-way between neighbouring rosettes.
class Ornament {
 public:
  explicit Ornament(const CarvedBallParameters& p) : half_(p.groove_width / 2) {
    Random random(static_cast<std::uint64_t>(p.seed));
    const Point turn{random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(0.1, 1)};
    const Eigen::Matrix3d m =
        Eigen::AngleAxisd(random.uniform(0, 2 * kPi), turn.normalized()).toRotationMatrix();
    for (const Point& corner : sphere({.radius = 1, .frequency = 1}).positions) {
      Rosette r;
      r.axis = m * corner;
      r.start = r.axis.unitOrthogonal();
      r.side = r.axis.cross(r.start);
      r.petals = 5 + static_cast<int>(random.below(4));
      r.wave = random.uniform(0.25, 0.4);
      r.phase = random.uniform(0, 2 * kPi);
      rosettes_.push_back(r);
    }
  }

  /// 0 on the ball, 1 on the bottom of a groove. \pre direction is a unit vector
  double depth(const Point& direction) const {
    double best = -2, second = -2;
    const Rosette* nearest = nullptr;
    for (const Rosette& r : rosettes_) {
      const double cosine = r.axis.dot(direction);
      if (cosine > best) {
        second = best;
        best = cosine;
        nearest = &r;
      } else {
        second = std::max(second, cosine);
      }
    }
    const double away = std::acos(std::min(1.0, best));
    const double between = (std::acos(std::clamp(second, -1.0, 1.0)) - away) / 2;
    const double ring = std::abs(away - kRing),
                 petal = std::abs(away - petal_at(*nearest, direction));
    return groove(std::min({between, ring, petal, std::max(0.0, away - half_)}));
  }

 private:
  static constexpr double kRing = 0.42;   // radians; neighbouring corners are 1.107 apart
  static constexpr double kPetal = 0.23;  // radians, the mean of the wavy ring

  static double petal_at(const Rosette& r, const Point& direction) {
    const double around = std::atan2(r.side.dot(direction), r.start.dot(direction));
    return kPetal * (1 + r.wave * std::cos(r.petals * around + r.phase));
  }

  // A groove is flat for half of its half width, and a smooth wall rises over the other half.
  double groove(double away) const {
    const double t = std::clamp(2 - 2 * away / half_, 0.0, 1.0);
    return t * t * (3 - 2 * t);
  }

  double half_;
  std::vector<Rosette> rosettes_;
};

}  // namespace

Triangles carved_ball(const CarvedBallParameters& p) {
  require_positive("carved_ball: radius", p.radius);
  require_range("carved_ball: depth", p.depth, {0, 0.6, "0 to 0.6 of the radius"});
  require_range("carved_ball: groove_width", p.groove_width,
                {0.01, 0.15, "0.01 to 0.15 of the radius"});
  require_resolution("carved_ball", 4 * kPi * p.radius * p.radius, p.edge_length);
  Triangles ball = sphere({.radius = 1, .edge_length = p.edge_length / p.radius});
  const Ornament ornament(p);
  const auto project = [&](const Point& q) -> Point {
    const Point direction = q.normalized();
    return direction * (1 - p.depth * ornament.depth(direction));
  };
  for (Point& q : ball.positions) q = project(q);
  // Six times the volume of a triangle's cone: a sliver seen from the centre is refused as well.
  const double least = 1e-3 * std::pow(p.edge_length / p.radius, 2);
  relax(ball.positions, ball.triangles,
        {0, kSweeps, project, [=](const Point& a, const Point& b, const Point& c) {
           return a.dot(b.cross(c)) > least * a.norm() * b.norm() * c.norm();
         }});
  for (Point& q : ball.positions) q = p.centre + p.radius * q;
  return ball;
}

}  // namespace suture
