// The places of the new surface's vertices: identity by site, never by coordinates [§6.1 steps 1,
// 2, 5].
#pragma once

#include <array>
#include <map>
#include <vector>

#include "surgery/detect/region.h"

namespace suture::surgery {

enum class SiteKind : std::uint8_t {
  corner,      ///< a vertex of the old mesh that stays
  type2,       ///< mesh edge × lattice face
  type1,       ///< triangle × lattice edge
  isosurface,  ///< the fill's own vertex on a lattice edge
  centroid     ///< middle of a loop that no other triangulation fits
};

struct Site {
  SiteKind kind;
  std::int8_t axis = 0;      ///< type 2: across the face; type 1, isosurface: along the edge
  std::uint32_t source = 0;  ///< corner: the old vertex; type 2: index in edge_crossings
  LatticeId at = 0;          ///< type 2: the face; type 1, isosurface: the lattice edge
  Point position = Point::Zero();
};

/// A directed segment on face `face` of a region cell (2·axis, + 1 for the upper one), as the patch
/// in the cell has it: seen from outside the cell, the material is on its right.
struct Arc {
  LatticeId cell;
  int face;
  std::uint32_t from, to;  ///< sites
};

/// Hands out one number for each site and constructs its position once, correctly rounded unless
/// the arithmetic is `rounded`.
class Sites {
 public:
  explicit Sites(const Detected& detected, Arithmetic arithmetic = Arithmetic::filtered);

  std::uint32_t corner(std::uint32_t vertex);
  /// \param mesh_edge the edge that crossing `crossing` is on
  std::uint32_t type2(std::uint32_t crossing, std::uint32_t mesh_edge);
  /// The site where `triangle` crosses a lattice edge.
  std::uint32_t type1(int axis, LatticeId edge, std::uint32_t triangle);
  /// The site on a lattice edge of the region that parts inside from outside: type 1 where the edge
  /// is on the region's boundary, an isosurface vertex (not yet placed) where all four cells are in
  /// it. \throw InternalFailure if a boundary edge is not crossed exactly once
  std::uint32_t on_lattice_edge(int axis, LatticeId edge);
  std::uint32_t centroid(const Point& position);

  /// The findings that the sites belong to.
  const Detected& detected() const { return in_; }

  const std::vector<Site>& all() const { return sites_; }
  Site& operator[](std::uint32_t id) { return sites_[id]; }
  const Site& operator[](std::uint32_t id) const { return sites_[id]; }

  /// Whether a type 2 site is on the region's boundary; else it was only inserted to split a
  /// triangle.
  bool at_boundary(const Site& type2) const {
    return in_.region.holds(type2.at) != in_.region.holds(step(type2.at, type2.axis, -1));
  }

  /// The point where `triangle` meets the line of a lattice edge, clamped to the edge.
  Point crossing_position(int axis, LatticeId edge, std::uint32_t triangle) const;

 private:
  std::uint32_t add(Site site);

  Detected in_;
  Arithmetic arithmetic_;
  std::vector<Site> sites_;
  SparseField<std::uint32_t> corners_, type2_;         // number + 1; 0 is "none yet"
  std::array<SparseField<std::uint32_t>, 3> on_edge_;  // edges at the region: one site each
  std::map<std::array<std::uint64_t, 3>, std::uint32_t> kept_;  // elsewhere: (triangle, axis, edge)
};

}  // namespace suture::surgery
