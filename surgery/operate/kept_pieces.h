// The part of one cut triangle outside the region, as triangles, and the arcs that it leaves there.
#pragma once

#include <optional>
#include <set>
#include <utility>
#include <vector>

#include "surgery/operate/sites.h"
#include "surgery/operate/triangle_pieces.h"
#include "surgery/operate/triangulate.h"

namespace suture::surgery {

/// The side of the region's boundary that pieces lie on.
enum class Part { outside, inside };

/// The pieces of one triangle outside the region (or, with Part::inside, those in it). All results
/// name vertices by site.
class KeptPieces {
 public:
  KeptPieces(const TrianglePieces& pieces, Sites& sites, Part part);

  /// The pieces merged across lattice faces where both cells are outside the region. Vertices on
  /// mesh edges: corners, crossings of the region's boundary, and those that `inserted` names.
  /// Nothing where no safe triangulation exists: a diagonal must not join two vertices of one mesh
  /// edge nor two that a patch could join too (both on one region cell) or, inside, that `avoid`
  /// has seen joined, and all triangles must keep the orientation.
  std::optional<std::vector<Triangle>> merged(const std::vector<char>& inserted);

  /// Pieces inside may not have the edges of these triangles, which the parts outside became, as
  /// diagonals. (On a triangle aligned with the lattice both could run along one line.)
  /// \pre Part::inside
  void avoid(const std::vector<Triangle>& outside);

  /// One polygon a cell, with every crossing a vertex.
  std::vector<Triangle> cell_by_cell();

  /// The kept sides on the region's boundary, reversed. \pre Part::outside
  std::vector<Arc> arcs();

 private:
  bool on_this_side(LatticeId cell) const {
    return in_.region.holds(cell) == (part_ == Part::inside);
  }
  bool kept(const PieceSide& s) const { return on_this_side(s.cell); }
  bool on_boundary(const PieceSide& s) const {
    return s.neighbour == kNoCell || !on_this_side(s.neighbour);
  }
  std::uint32_t next_on_boundary(std::uint32_t side) const;
  std::vector<std::uint32_t> loop_from(std::uint32_t side, const std::vector<char>& inserted,
                                       std::vector<char>& seen) const;
  std::vector<std::uint32_t> components() const;
  std::optional<std::vector<Triangle>> triangulate(
      const std::vector<std::vector<std::uint32_t>>& loops);
  bool forbidden(std::uint32_t a, std::uint32_t b) const;
  bool is_too_long(std::size_t corners) const;
  std::uint32_t global(std::uint32_t local);

  const Detected& in_;
  std::uint32_t triangle_;
  const TrianglePieces& pieces_;
  Sites& sites_;
  Part part_;
  std::set<std::pair<std::uint32_t, std::uint32_t>> taken_;
  std::vector<std::uint32_t> global_;  // local site → site, kNone while not asked for
};

}  // namespace suture::surgery
