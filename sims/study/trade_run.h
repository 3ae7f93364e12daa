// A run of a scene for a trade study: its cost, and its error against the reference.
#pragma once

#include <filesystem>

#include "sims/scene/scene.h"
#include "sims/study/table/row.h"

namespace suture::sims {

struct TradeRun {
  std::filesystem::path scene;
  SceneChanges changes;
  std::filesystem::path reference;     ///< mesh to measure against; empty: nothing is measured
  std::vector<std::int64_t> topology;  ///< components and Euler characteristic that are right;
                                       ///< empty: the reference's
  std::filesystem::path surface;       ///< where the last surface goes; empty: nowhere
  std::size_t samples = 20000;         ///< on each surface, for distances
};

/// Runs the scene's mesh without pictures. \return outcome, failure, every figure of a trade row
/// and the surface's fingerprint; bad input and internal failures are an outcome. Memory and
/// seconds are of this process, so it should run in one of its own, and without the measuring.
Row run_once(const TradeRun& run);

}  // namespace suture::sims
