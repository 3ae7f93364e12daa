// The surface that a scene should have at a time, kept on disk once it was computed.
#pragma once

#include <filesystem>
#include <string>

#include "sims/study/exact/exact_flow.h"

namespace suture::sims {

struct TruthOptions {
  std::string kind = "exact";    ///< or "polyhedron": the start mesh itself, carried exactly
  double tolerance = 0;          ///< of its chords, in the scene's unit
  std::filesystem::path folder;  ///< where it is kept; empty: nowhere
};

struct Truth {
  ExactSurface exact;
  double volume = 0;  ///< analytic where the start shape is known; every field here keeps it
};

/// The start shape carried to `time` by the exact flow of the scene. One that is in the folder,
/// made from the same shape, motion, time and tolerance, is taken from there; several processes may
/// share a folder. \throw InvalidInput as exact_carry and exact_flow, or if it cannot be written
Truth truth_at(const Scene& scene, double time, const TruthOptions& options);

}  // namespace suture::sims
