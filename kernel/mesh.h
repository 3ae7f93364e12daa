// The inner mesh: CGAL's Surface_mesh over doubles, and its conversions. Pulls in CGAL.
#pragma once

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Surface_mesh.h>

#include "kernel/triangles.h"

namespace suture {

using CgalKernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using CgalPoint = CgalKernel::Point_3;
using Mesh = CGAL::Surface_mesh<CgalPoint>;

inline Point to_point(const CgalPoint& p) { return {p.x(), p.y(), p.z()}; }
inline CgalPoint to_cgal(const Point& p) { return {p.x(), p.y(), p.z()}; }

/// The mesh with the same vertex and face order. \pre edge- and vertex-manifold, oriented
/// \throw InternalFailure if a face cannot be added
Mesh to_mesh(const Triangles& surface);

/// Indexed copy, in index order; vertices and faces removed from `mesh` but not collected are left
/// out.
Triangles to_triangles(const Mesh& mesh);

}  // namespace suture
