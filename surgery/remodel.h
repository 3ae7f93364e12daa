// One remodel as a transaction: detect, cut, fill, stitch on a copy, audit, and only then commit.
#pragma once

#include "kernel/trace.h"
#include "surgery/model/options.h"
#include "surgery/model/report.h"
#include "surgery/model/surface.h"

namespace suture::surgery {

/// The options, the oracle and the listener of a remodel or an improvement. All must outlive it.
struct Setup {
  const TrackerOptions& options;
  const Oracle& oracle;
  Trace* trace = nullptr;  ///< null: nobody listens
};

/// Remodels `surface` in place, or leaves it untouched to the last bit and says why in the report.
/// \pre closed manifold, finite, without garbage; or empty
/// \throw InvalidInput if the lattice would not fit the indices or the memory
SurgeryReport remodel(Surface& surface, const Setup& setup);

}  // namespace suture::surgery
