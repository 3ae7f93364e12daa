// The paper's remedy against degeneracy, for plain doubles only: vertices move at random [§5.3].
#pragma once

#include "surgery/model/options.h"
#include "surgery/model/surface.h"

namespace suture::surgery {

/// Whether remodels of these options work on a jittered copy.
bool jitters(const TrackerOptions& options);

/// The surface with every coordinate moved by up to options.jitter cells, at random by each
/// vertex's number and coordinates: equal surfaces move alike, and others do not.
Surface jittered(Surface surface, const TrackerOptions& options);

}  // namespace suture::surgery
