// One triangle cut by the lattice into convex pieces, one a cell [§6.1 steps 1 and 2].
#pragma once

#include <vector>

#include "surgery/detect/crossings.h"

namespace suture::surgery {

/// The cell across a side that is on a mesh edge: none.
inline constexpr LatticeId kNoCell = ~LatticeId{0};

/// A directed side of a piece; the piece is on its left. Sites are numbered within the triangle.
struct PieceSide {
  LatticeId cell;
  LatticeId neighbour;  ///< cell across the side, or kNoCell on a mesh edge
  std::uint32_t from, to;
  int mesh_edge = -1;          ///< 0, 1, 2 on a mesh edge
  std::uint32_t next = kNone;  ///< the next side round the piece
  std::uint32_t twin = kNone;  ///< the same side as the neighbour's piece has it
};

/// Pieces of one triangle. Local sites: corners 0 to 2, then its edges' crossings, then its lines'.
struct TrianglePieces {
  std::uint32_t triangle = 0;
  std::vector<PieceSide> sides;  ///< grouped by cell
  struct EdgeSite {
    std::uint32_t crossing;  ///< index of edge_crossings
    int mesh_edge;           ///< 0, 1, 2
  };
  std::vector<EdgeSite> edge_sites;
  struct LineSite {
    int axis;
    LatticeId edge;
  };
  std::vector<LineSite> line_sites;  ///< sorted

  bool is_corner(std::uint32_t site) const { return site < 3; }
  bool is_edge_site(std::uint32_t site) const { return site >= 3 && site < 3 + edge_sites.size(); }
  const EdgeSite& edge_site(std::uint32_t site) const { return edge_sites[site - 3]; }
  const LineSite& line_site(std::uint32_t site) const {
    return line_sites[site - 3 - edge_sites.size()];
  }
};

/// Walks the triangle's lattice paths. Each piece's sides form one cycle of at least three.
/// \throw InternalFailure where they do not (no exact oracle does that)
TrianglePieces triangle_pieces(const CrossedMesh& in, std::uint32_t triangle);

}  // namespace suture::surgery
