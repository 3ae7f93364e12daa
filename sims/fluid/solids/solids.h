// Solid walls and bodies, still or moving as the scene says, and what they leave open of a face.
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
  /// All that is outside of a box. The makers throw InvalidInput where a number is not finite, a
  /// size not positive, or a period not positive.
  static Solid container(const Box& inside, const SolidMotion& motion = {});
  static Solid box(const Box& box, const SolidMotion& motion = {});
  static Solid ball(const Point& centre, double radius, const SolidMotion& motion = {});
  /// A closed surface, by the physics grid it meets: its distances are asked for once, at the
  /// corners of cells of that origin and h, exact there and linear in between; more than kSolidBand
  /// cells off they are only at least as large as that.
  static Solid mesh(const Triangles& surface, const Point& origin, double h,
                    const SolidMotion& motion = {});

  /// Signed, in the scene's unit: negative inside the solid.
  double distance(const Point& p, double t) const;
  /// Of the solid's material.
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
  /// To the nearest; infinite where there is none.
  double distance(const Point& p, double t) const;
  /// Of the solid that is nearest to p, or that p is deepest in.
  Point velocity(const Point& p, double t) const;
  /// The unit vector out of the solids at p, by differences over `step`; 0 where D has no slope.
  Point normal(const Point& p, double t, double step) const;
};

/// What of each face a solid leaves open; empty arrays: the scene has no solids.
struct SolidFaces {
  std::array<std::vector<double>, 3> open, velocity;  ///< open share 0 to 1 of face (axis, slot);
                                                      ///< the solid's component there
  bool any() const { return !open[0].empty(); }
  double open_at(int axis, Slot s) const { return any() ? open[axis][s] : 1; }
  double velocity_at(int axis, Slot s) const { return any() ? velocity[axis][s] : 0; }
  std::size_t memory() const;
};

/// A face that is open less than this is closed: a cell that only such faces join to the others
/// would have a row so small that the solver's tolerance says nothing about its velocities.
inline constexpr double kLeastOpen = 0.01;

/// By the distances at a face's corners and middle, linear in between [Batty et al. 2007, §4]. What
/// is within rounding of a solid is in it: a wall on a plane of the grid closes what is on it.
SolidFaces faces_of(const Solids& solids, const SparseGrid& grid, double t);

}  // namespace suture::sims
