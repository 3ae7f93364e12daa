// Positions of inserted vertices: the double nearest to the exact intersection, clamped to its cell
// [§6.1].
#pragma once

#include "kernel/triangles.h"

namespace suture {

/// Coordinate `want` of the point where segment pq meets the plane {x_axis = plane}, correctly
/// rounded (to nearest, ties to even; zero is +0), infinite where it overflows, for any finite
/// doubles. \pre p_axis != q_axis
/// \throw InternalFailure where that fails and no coordinate can be given
double on_edge(const Point& p, const Point& q, int axis, double plane, int want);

/// Coordinate `axis` of the point where the plane of triangle abc meets the line along `axis`
/// through `through` (whose own `axis` coordinate is not read), rounded as above, for any finite
/// doubles. \pre the normal's `axis` component is not zero
/// \throw InternalFailure where that fails and no coordinate can be given
double on_triangle(const Point& a, const Point& b, const Point& c, int axis, const Point& through);

/// The same two by a few operations of plain doubles, as the paper's authors had: off by some bits,
/// by any amount near parallel, NaN where it divides by zero (which clamp_to_cell takes).
double rounded_on_edge(const Point& p, const Point& q, int axis, double plane, int want);
double rounded_on_triangle(const Point& a, const Point& b, const Point& c, int axis,
                           const Point& through);

/// x, or the nearest double in (low, high] if it is outside: the doubles that cell_of gives to that
/// cell. NaN gives `high`.
double clamp_to_cell(double x, double low, double high);

}  // namespace suture
