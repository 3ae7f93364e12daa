// Exact signs by CGAL's predicates: intervals first, then numbers of any length.
#include "predicates/exact_signs.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

namespace suture {

namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;

Kernel::Point_2 cgal_point(const Eigen::Vector2d& p) { return {p[0], p[1]}; }
Kernel::Point_3 cgal_point(const Point& p) { return {p[0], p[1], p[2]}; }

}  // namespace

int exact_orientation(const Eigen::Vector2d& p, const Eigen::Vector2d& q,
                      const Eigen::Vector2d& r) {
  return CGAL::orientation(cgal_point(p), cgal_point(q), cgal_point(r));
}

int exact_orientation(const Point& a, const Point& b, const Point& c, const Point& d) {
  return CGAL::orientation(cgal_point(a), cgal_point(b), cgal_point(c), cgal_point(d));
}

}  // namespace suture
