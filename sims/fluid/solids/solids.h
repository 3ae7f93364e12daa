// Solid walls and bodies, still or moving as the scene says.
#pragma once

#include <memory>
#include <vector>

#include "kernel/lattice.h"
#include "kernel/triangles.h"
#include "sims/fluid/grid/sparse_grid.h"

namespace suture::sims {

/// A translation in time: velocity·t + amplitude·sin(2π·t/period).
struct SolidMotion {
  Point velocity = Point::Zero();
  Point amplitude = Point::Zero();
  double period = 1;  ///< > 0

  Point displacement(double t) const;
  Point velocity_at(double t) const;
  double fastest() const;  ///< no speed is above it
};

inline constexpr int kSolidBand = 4;  ///< cells

/// One solid: where it is, and how its points move.
class Solid {
 public:
  /// The solid is all that is outside of a box. The makers throw InvalidInput where a number is not
  /// finite, a size not positive, or a period not positive.
  static Solid container(const Box& inside, const SolidMotion& motion = {});
  static Solid box(const Box& box, const SolidMotion& motion = {});
  static Solid ball(const Point& centre, double radius, const SolidMotion& motion = {});
  /// A closed surface, by the physics grid it meets: its distances are asked for once, at the
  /// corners of the frame's cells, exact there and linear in between; more than kSolidBand cells
  /// off they are only at least as large as that.
  static Solid mesh(const Triangles& surface, const GridFrame& frame,
                    const SolidMotion& motion = {});

  /// Signed, in the scene's unit: negative inside the solid.
  double distance(const Point& p, double t) const;
  /// The velocity of the solid's material.
  Point velocity(double t) const { return motion_.velocity_at(t); }
  double fastest() const { return motion_.fastest(); }  ///< no speed is above it
  std::size_t memory() const;

  struct Shape;

 private:
  Solid(std::shared_ptr<const Shape> shape, const SolidMotion& motion);
  std::shared_ptr<const Shape> shape_;
  SolidMotion motion_;
};

/// All solids of a scene: their union.
struct Solids {
  std::vector<Solid> all;

  bool any() const { return !all.empty(); }
  double fastest() const;  ///< no speed is above it
  std::size_t memory() const;
  /// The distance to the nearest; infinite where there is none.
  double distance(const Point& p, double t) const;
  /// The velocity of the solid that is nearest to p, or that p is deepest in.
  Point velocity(const Point& p, double t) const;
  /// The unit vector out of the solids at p, by differences over `step`; 0 where D has no slope.
  Point normal(const Point& p, double t, double step) const;
};

/// Solids where they are at a time. Keeps a reference to them.
class SolidsAt {
 public:
  SolidsAt(const Solids& solids, double t) : solids_(solids), t_(t) {}

  bool any() const { return solids_.any(); }
  double distance(const Point& p) const { return solids_.distance(p, t_); }
  Point velocity(const Point& p) const { return solids_.velocity(p, t_); }
  Point normal(const Point& p, double step) const { return solids_.normal(p, t_, step); }

 private:
  const Solids& solids_;
  double t_;
};

}  // namespace suture::sims
