// Corefinement takes a minute to compile, so it stands alone.
#include "tests/surgery/exact_union.h"

#include <CGAL/Polygon_mesh_processing/corefinement.h>
#include <CGAL/Polygon_mesh_processing/repair_self_intersections.h>

#include "kernel/errors.h"
#include "kernel/measure/measures.h"
#include "kernel/mesh.h"

namespace suture {

namespace {

namespace pmp = CGAL::Polygon_mesh_processing;

/// Corefinement wants surfaces that do not meet themselves: the horse scan does in four places.
Mesh embedded(const Triangles& surface) {
  Mesh mesh = to_mesh(surface);
  if (pmp::does_self_intersect(mesh)) {
    pmp::experimental::remove_self_intersections(mesh);
    mesh.collect_garbage();
  }
  return mesh;
}

}  // namespace

double exact_union_volume(const Triangles& a, const Triangles& b) {
  Mesh first = embedded(a), second = embedded(b), both;
  if (!pmp::corefine_and_compute_union(first, second, both))
    throw InternalFailure("exact_union", "corefinement could not make the union");
  return volume(to_triangles(both));
}

}  // namespace suture
