// The decisions that surgery asks for: signs of input doubles against the shifted lattice, and
// nothing else.
#pragma once

#include <cstdint>
#include <memory>
#include <utility>

#include "kernel/triangles.h"

namespace suture {

enum class Arithmetic {
  rounded,  ///< plain doubles, as the paper's authors had: may be wrong, and then the audit refuses
  filtered,  ///< exact: doubles where a proven bound allows, longer numbers elsewhere
  rational   ///< exact and slow: the independent twin
};

/// Counts of each decision asked for, and of those that a floating-point filter could not decide.
struct OracleCounts {
  std::uint64_t edge_side = 0, triangle_side = 0, orientation = 0, filter_failures = 0;
};

/// Counts the questions that this thread puts to oracles while the tally stands. Tallies of a
/// thread nest: only the innermost counts. Each thread has its own, so that oracles hold no counts.
class OracleTally {
 public:
  OracleTally() : outer_(std::exchange(asked_, {})) {}
  ~OracleTally() { asked_ = outer_; }
  OracleTally(const OracleTally&) = delete;
  OracleTally& operator=(const OracleTally&) = delete;

  /// The questions so far. \pre no other tally of this thread stands that was made later
  static const OracleCounts& counts() { return asked_; }

 private:
  friend class Oracle;
  static inline constinit thread_local OracleCounts asked_{};
  OracleCounts outer_;
};

/// A line of the lattice seen along its own axis: the point (u + ε_u, v + ε_v) of the plane of two
/// axes.
struct LatticePoint2 {
  int u_axis, v_axis;  ///< two different axes, in either order
  double u, v;         ///< planes of the lattice on those axes, exactly
};

/// Signs, exact unless a backend says otherwise. The lattice stands at (ε₀, ε₁, ε₂) from where its
/// doubles say, ε₀ ≫ ε₁ ≫ ε₂ > 0 (Simulation of Simplicity), axis 0 shifted most; mesh points stay.
/// Callers pass only mesh vertices' doubles and lattice planes, never a constructed point's exact
/// self. All finite doubles will do, subnormal ones and those whose differences overflow too.
/// An oracle does not change, so that threads may share one.
/// \pre every coordinate is finite, which Tracker and Lattice see to
class Oracle {
 public:
  virtual ~Oracle() = default;

  /// Side of the directed segment p→q, projected to (u,v) axes, that the lattice point is on:
  /// sign of (q_u−p_u)(v+ε_v−p_v) − (q_v−p_v)(u+ε_u−p_u); +1 left (counter-clockwise), −1 right,
  /// 0 only where p and q project to one point.
  virtual int edge_side(const Point& p, const Point& q, const LatticePoint2& at) const = 0;

  /// Side of the triangle's plane that the shifted node is on: sign of N·(node+ε−a) with
  /// N = (b−a)×(c−a); +1 where N points, 0 only where N is zero.
  virtual int triangle_side(const Point& a, const Point& b, const Point& c,
                            const Point& node) const = 0;

  /// Sign of N·(d−a), N = (b−a)×(c−a): no shift, 0 where the four are coplanar.
  virtual int orientation(const Point& a, const Point& b, const Point& c, const Point& d) const = 0;

 protected:
  /// The innermost tally of this thread, to count a question in.
  static OracleCounts& asked() { return OracleTally::asked_; }
};

/// Answers the sign of each determinant's rounded value: a computed zero is answered as 0 (on
/// neither side), and nothing is shifted. Its cost is the least there is.
std::unique_ptr<Oracle> make_rounded_oracle();

/// Answers by a floating-point filter with a proven error bound, and exactly where that cannot
/// decide. The default.
/// \throw InvalidInput if this thread rounds other than to nearest or flushes subnormal numbers
std::unique_ptr<Oracle> make_filtered_oracle();

/// Answers by GMP's whole numbers with concrete shifts 2^-6000, 2^-12000, 2^-18000 in place of
/// symbols: slow, and shares no code with the filtered one.
std::unique_ptr<Oracle> make_rational_oracle();

std::unique_ptr<Oracle> make_oracle(Arithmetic arithmetic);

}  // namespace suture
