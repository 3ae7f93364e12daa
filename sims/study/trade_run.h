// One run of a scene for a study: its cost, and its error against the reference.
#pragma once

#include <filesystem>

#include "sims/study/table/row.h"

namespace suture::sims {

struct OneRun {
  std::filesystem::path scene;
  SceneChanges changes;
  std::filesystem::path reference;     ///< mesh to measure against; empty: nothing is measured
  std::vector<std::int64_t> topology;  ///< components and Euler characteristic that are right;
                                       ///< empty: the reference's
  std::filesystem::path surface;       ///< where the last surface goes; empty: nowhere
  std::size_t samples = 20000;         ///< on each surface, for distances
};

/// Runs the scene without pictures and fills in outcome, failure, figures and surface; bad input
/// and internal failures are an outcome. Memory and seconds are of this process, so it should run
/// in one of its own, and without the measuring. \throw nothing that a run is to survive
Row run_once(const OneRun& run);

/// A row's outcome, failure, figures and surface as bytes to be sent between processes, and back.
std::string packed(const Row& row);
Row unpacked(const std::string& bytes);

}  // namespace suture::sims
