// One call of the tracker seen from outside, and what may be wrong with it.
#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "kernel/triangles.h"
#include "surgery/model/options.h"
#include "surgery/model/report.h"

namespace suture::sims {

struct Observation {
  std::uint64_t seed = 0;
  const TrackerOptions& options;
  const Triangles& before;
  const Triangles& after;
  const SurgeryReport* surgery = nullptr;  ///< of a remodel
  const QualityReport* quality = nullptr;  ///< of an improvement
  bool moved = true;  ///< whether anything but a committed remodel came just before
};

/// A check's complaint in one line; empty if nothing is wrong.
using Objection = std::optional<std::string>;

/// Whether a remodel changed the surface.
inline bool committed(const Observation& o) {
  return o.surgery != nullptr && o.surgery->outcome == Outcome::committed;
}

}  // namespace suture::sims
