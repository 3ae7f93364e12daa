// Corefinement takes a minute to compile, so it stands alone.
#include "tests/surgery/exact_union.h"

#include <CGAL/Polygon_mesh_processing/corefinement.h>

#include "kernel/errors.h"
#include "kernel/measures.h"
#include "kernel/mesh.h"

namespace suture {

double exact_union_volume(const Triangles& a, const Triangles& b) {
  Mesh first = to_mesh(a), second = to_mesh(b), both;
  if (!CGAL::Polygon_mesh_processing::corefine_and_compute_union(first, second, both))
    throw InternalFailure("exact_union", "corefinement could not make the union");
  return volume(to_triangles(both));
}

}  // namespace suture
