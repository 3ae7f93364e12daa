// The counts of a run, for its user's last line.
#pragma once

#include <cstdint>
#include <string>

#include "kernel/audit.h"

namespace suture::sims {

/// All that a run did, from its start to where it ended.
struct RunSummary {
  std::int64_t steps = 0;
  std::size_t remodels = 0, committed = 0, refused = 0, merges = 0, splits = 0;
  std::size_t vanished = 0;  ///< bodies thinner than a cell, or cavities, that surgery removed
  std::size_t meshes = 0, pictures = 0;
  std::size_t unconverged = 0;  ///< linear solves of the fluid whose last iterate was used
  std::string reproducer;       ///< of the first surgery that was refused
  std::string failure;          ///< why it was
  Audit audit;                  ///< of the last surface
};

}  // namespace suture::sims
