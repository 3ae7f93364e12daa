// Solid walls and bodies: distances, motions.
#include "sims/fluid/solids/solids.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "kernel/errors.h"
#include "kernel/measure/signed_distance.h"
#include "sims/fluid/grid/sampled_surface.h"

namespace suture::sims {

/// A solid at rest where its motion begins.
struct Solid::Shape {
  Shape() = default;
  Shape(const Shape&) = delete;
  Shape& operator=(const Shape&) = delete;
  virtual ~Shape() = default;
  virtual double distance(const Point& p) const = 0;
  virtual std::size_t memory() const { return sizeof(*this); }
};

namespace {

/// Differences of coordinates alone: 0 exactly where p is on a side.
double distance_to_box(const Point& p, const Box& box) {
  Point beyond;
  for (int a = 0; a < 3; ++a) beyond[a] = std::max(box.low[a] - p[a], p[a] - box.high[a]);
  const double most = beyond.maxCoeff();
  if (most <= 0) return most;
  const Point outside = beyond.cwiseMax(0);
  return outside.sum() == most ? most : outside.stableNorm();  // mostly beyond one side alone
}

struct BoxShape : Solid::Shape {
  Box box;
  double sign;  ///< −1: what is outside of the box is solid
  BoxShape(const Box& b, double s) : box(b), sign(s) {}
  double distance(const Point& p) const override { return sign * distance_to_box(p, box); }
};

struct BallShape : Solid::Shape {
  Point centre;
  double radius;
  BallShape(const Point& c, double r) : centre(c), radius(r) {}
  double distance(const Point& p) const override { return (p - centre).stableNorm() - radius; }
};

/// Distances at nodes of a lattice, near the surface exact, else ± the band's width.
struct MeshShape : Solid::Shape {
  SparseGrid nodes;  ///< its cells' centres are the lattice's nodes
  std::vector<double> values;
  Box bounds;
  double band;

  MeshShape(const Triangles& surface, const GridFrame& frame)
      : bounds(bounding_box(surface.positions)), band(kSolidBand * frame.h) {
    const SignedDistance exact(surface);
    const SampledSurface cells = sample_surface(
        surface, [&](const Point& p) { return exact.at(p); },
        {frame.origin - Point::Constant(frame.h / 2), frame.h}, kSolidBand);
    nodes = grid_round(cells, kSolidBand);
    values.assign(nodes.size(), band);
    for (Slot s = 0; s < nodes.size(); ++s) {
      const Slot there = cells.grid.find(nodes.cell(s));
      if (there == kNoSlot) continue;
      values[s] = cells.near[there] != 0 ? std::clamp(cells.distance[there], -band, band)
                                         : std::copysign(band, cells.distance[there]);
    }
    for (const SampledSurface::Run& run : cells.deep)
      for (Index3 c = run.first; c[2] < run.first[2] + run.count; ++c[2])
        values[nodes.find(c)] = -band;
  }
  double distance(const Point& p) const override {
    const double off = distance_to_box(p, bounds);
    if (off >= band) return off;
    const Point low = (p - nodes.origin()) / nodes.h() - Point::Constant(0.5);
    Index3 cell;
    Point between;
    for (int a = 0; a < 3; ++a) {
      const double whole = std::floor(low[a]);
      cell[a] = static_cast<int>(whole);
      between[a] = low[a] - whole;
    }
    double sum = 0;
    for (int n = 0; n < 8; ++n) {
      Index3 c = cell;
      double weight = 1;
      for (int a = 0; a < 3; ++a) {
        const int up = n >> a & 1;
        c[a] += up;
        weight *= up != 0 ? between[a] : 1 - between[a];
      }
      if (weight == 0) continue;
      const Slot s = nodes.find(c);
      sum += weight * (s == kNoSlot ? band : values[s]);
    }
    return sum;
  }
  std::size_t memory() const override {
    return sizeof(*this) + values.size() * sizeof(double) + nodes.blocks().size() * sizeof(Index3);
  }
};

[[noreturn]] void refuse(const char* what) { throw InvalidInput(std::string("solid: ") + what); }

void check(const Box& box) {
  if (!box.low.allFinite() || !box.high.allFinite() || !((box.high - box.low).minCoeff() > 0))
    refuse("a box needs finite corners, the high one above the low one on each axis");
}

}  // namespace

Point SolidMotion::displacement(double t) const {
  return velocity * t + amplitude * std::sin(2 * std::numbers::pi * t / period);
}

Point SolidMotion::velocity_at(double t) const {
  const double frequency = 2 * std::numbers::pi / period;
  return velocity + amplitude * (frequency * std::cos(frequency * t));
}

double SolidMotion::fastest() const {
  return velocity.norm() + amplitude.norm() * (2 * std::numbers::pi / period);
}

Solid::Solid(std::shared_ptr<const Shape> shape, const SolidMotion& motion)
    : shape_(std::move(shape)), motion_(motion) {
  if (!motion.velocity.allFinite() || !motion.amplitude.allFinite() ||
      !std::isfinite(motion.period) || !(motion.period > 0))
    refuse("a motion needs finite numbers and a period above 0");
}

Solid Solid::container(const Box& inside, const SolidMotion& motion) {
  check(inside);
  return {std::make_shared<BoxShape>(inside, -1), motion};
}

Solid Solid::box(const Box& box, const SolidMotion& motion) {
  check(box);
  return {std::make_shared<BoxShape>(box, 1), motion};
}

Solid Solid::ball(const Point& centre, double radius, const SolidMotion& motion) {
  if (!centre.allFinite() || !std::isfinite(radius) || !(radius > 0))
    refuse("a ball needs a finite centre and a finite radius above 0");
  return {std::make_shared<BallShape>(centre, radius), motion};
}

Solid Solid::mesh(const Triangles& surface, const GridFrame& frame, const SolidMotion& motion) {
  if (surface.triangles.empty()) refuse("a mesh needs a triangle");
  return {std::make_shared<MeshShape>(surface, frame), motion};
}

double Solid::distance(const Point& p, double t) const {
  return motion_.fastest() == 0 ? shape_->distance(p)
                                : shape_->distance(p - motion_.displacement(t));
}

std::size_t Solid::memory() const { return shape_->memory(); }

double Solids::fastest() const {
  double most = 0;
  for (const Solid& solid : all) most = std::max(most, solid.fastest());
  return most;
}

std::size_t Solids::memory() const {
  std::size_t bytes = 0;
  for (const Solid& solid : all) bytes += solid.memory();
  return bytes;
}

double Solids::distance(const Point& p, double t) const {
  double least = std::numeric_limits<double>::infinity();
  for (const Solid& solid : all) least = std::min(least, solid.distance(p, t));
  return least;
}

Point Solids::velocity(const Point& p, double t) const {
  const Solid* nearest = nullptr;
  double least = std::numeric_limits<double>::infinity();
  for (const Solid& solid : all)
    if (const double d = solid.distance(p, t); d < least) {
      least = d;
      nearest = &solid;
    }
  return nearest == nullptr ? Point(Point::Zero()) : nearest->velocity(t);
}

Point Solids::normal(const Point& p, double t, double step) const {
  if (all.empty()) return Point::Zero();
  Point slope;
  for (int a = 0; a < 3; ++a) {
    Point low = p, high = p;
    low[a] -= step;
    high[a] += step;
    slope[a] = distance(high, t) - distance(low, t);
  }
  return slope.stableNorm() > 0 ? slope.stableNormalized() : slope;
}

}  // namespace suture::sims
