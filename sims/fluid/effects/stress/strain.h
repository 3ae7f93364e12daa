// The elastic strain that a liquid carries with it.
#pragma once

#include "sims/fluid/effects/stress/strain_rate.h"

namespace suture::sims {

/// Elastic strain, staggered as the strain rate that makes it: no component is ever averaged to
/// another's place for the force, which so is the exact slope of an energy. Empty: there is none.
struct Strain {
  SharedGrid grid;
  TensorField elastic;
  std::array<std::vector<std::uint8_t>, 4> known;  ///< in liquid: cells, and edges by axis

  Strain() = default;
  explicit Strain(SharedGrid g);  ///< 0, and known nowhere; \pre g is not null
  bool any() const { return elastic.any(); }
  std::size_t memory() const;
};

/// Turns the strain with the liquid, by half the curl over dt, and carries it along: by
/// MacCormack's scheme, clamped, as the velocity's [Selle et al. 2008]. That is the co-rotational
/// rate of Jaumann; what a rigid motion carries keeps its size. New liquid that no old one reaches
/// has none. \pre u is known in the old liquid and wherever the new one came from; the grids of
/// `old` and `liquid` have one origin and h
Strain carried(const Strain& old, const MacVelocity& u, const Liquid& liquid, double dt);

}  // namespace suture::sims
