// The surface over an edge, as the vertices around it tell it [§6.2; Cazals and Pouget 2005].
#pragma once

#include <array>
#include <optional>

#include "kernel/mesh.h"

namespace suture::surgery {

/// The curve over an edge on a polynomial surface of degree 2 to 4, fitted to the vertices of the
/// two rings around it as heights over the plane that has the edge in it. Where the surface is
/// smooth it is off by the order of the edge's length to the power of the degree + 1.
class FittedCurve {
 public:
  /// \return nothing where the rings do not lie smoothly over one plane, or are too few vertices
  static std::optional<FittedCurve> fit(const Mesh& mesh, Mesh::Halfedge_index h);

  /// The point over source + part × (target − source). \pre part is 0 to 1
  Point at(double part) const;

 private:
  Point source_, along_, normal_;    ///< of the edge; `normal_` is of unit length
  std::array<double, 5> heights_{};  ///< by powers of part − 1/2, in lengths of the edge
};

}  // namespace suture::surgery
