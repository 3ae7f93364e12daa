// Positions: lattice coordinates exact, the rest correctly rounded and clamped to the located cell.
#include "surgery/operate/sites.h"

#include "kernel/errors.h"
#include "predicates/construct.h"

namespace suture::surgery {

Sites::Sites(const Detected& detected, Arithmetic arithmetic)
    : in_(detected), arithmetic_(arithmetic) {}

std::uint32_t Sites::add(Site site) {
  sites_.push_back(site);
  return static_cast<std::uint32_t>(sites_.size() - 1);
}

std::uint32_t Sites::corner(std::uint32_t vertex) {
  std::uint32_t& known = corners_[vertex];
  if (known == 0) known = 1 + add({SiteKind::corner, 0, vertex, 0, in_.mesh.positions[vertex]});
  return known - 1;
}

std::uint32_t Sites::type2(std::uint32_t crossing, std::uint32_t mesh_edge) {
  std::uint32_t& known = type2_[crossing];
  if (known != 0) return known - 1;
  const FaceStep& face = in_.crossings.edge_crossings[crossing];
  const Index3 at = unpack(face.face);
  const auto& [p, q] = in_.mesh.edges[mesh_edge];
  const Lattice& lattice = in_.on.lattice;
  Site site{SiteKind::type2, static_cast<std::int8_t>(face.axis), crossing, face.face, {}};
  const double plane = lattice.plane(face.axis, at[face.axis]);
  site.position[face.axis] = plane;
  const auto crossing_at = arithmetic_ == Arithmetic::rounded ? rounded_on_edge : on_edge;
  for (const int axis : {next_axis(face.axis), prev_axis(face.axis)})
    site.position[axis] = clamp_to_cell(
        crossing_at(in_.mesh.positions[p], in_.mesh.positions[q], face.axis, plane, axis),
        lattice.plane(axis, at[axis]), lattice.plane(axis, at[axis] + 1));
  known = 1 + add(site);
  return known - 1;
}

Point Sites::crossing_position(int axis, LatticeId edge, std::uint32_t triangle) const {
  const Index3 at = unpack(edge);
  const Lattice& lattice = in_.on.lattice;
  Point position = lattice.node(at);
  const Triangle& t = in_.mesh.triangles[triangle];
  const auto crossing_at = arithmetic_ == Arithmetic::rounded ? rounded_on_triangle : on_triangle;
  position[axis] = clamp_to_cell(crossing_at(in_.mesh.positions[t[0]], in_.mesh.positions[t[1]],
                                             in_.mesh.positions[t[2]], axis, position),
                                 lattice.plane(axis, at[axis]), lattice.plane(axis, at[axis] + 1));
  return position;
}

std::uint32_t Sites::type1(int axis, LatticeId edge, std::uint32_t triangle) {
  const int held = in_.region.cells_round_edge(edge, axis);  // within the region sheets may be many
  std::uint32_t& known = held > 0 && held < 4
                             ? on_edge_[axis][edge]
                             : kept_[{triangle, static_cast<std::uint64_t>(axis), edge}];
  if (known == 0)
    known = 1 + add({SiteKind::type1, static_cast<std::int8_t>(axis), triangle, edge,
                     crossing_position(axis, edge, triangle)});
  return known - 1;
}

std::uint32_t Sites::on_lattice_edge(int axis, LatticeId edge) {
  if (in_.region.cells_round_edge(edge, axis) < 4) {
    const CrossedEdge* crossed = in_.winding.edge(axis, unpack(edge));
    if (!crossed || crossed->count != 1)
      throw InternalFailure("fill", "an edge on the region's boundary is not crossed exactly once");
    return type1(axis, edge,
                 in_.crossings.line_crossings[in_.winding.order(axis)[crossed->first]].triangle);
  }
  std::uint32_t& known = on_edge_[axis][edge];
  if (known == 0) {
    const CrossedEdge* crossed = in_.winding.edge(axis, unpack(edge));
    if (!crossed)
      throw InternalFailure("fill", "a side changes along an edge that nothing crosses");
    known = 1 + add({SiteKind::isosurface, static_cast<std::int8_t>(axis), 0, edge,
                     in_.on.lattice.node(unpack(edge))});
  }
  return known - 1;
}

std::uint32_t Sites::centroid(const Point& position) {
  return add({SiteKind::centroid, 0, 0, 0, position});
}

}  // namespace suture::surgery
