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

/// The mesh with the vertices and faces in the same order. \pre the surface is oriented, and
/// manifold at its edges and vertices \throw InternalFailure if a face cannot be added
Mesh to_mesh(const Triangles& surface);

/// An indexed copy in the order of the mesh's indices. Vertices and faces that were removed from
/// the mesh but not collected are left out.
Triangles to_triangles(const Mesh& mesh);

}  // namespace suture
