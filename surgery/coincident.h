// Bodies that are exact copies of one another: their union is one of them, without re-sampling.
#pragma once

#include <vector>

#include "kernel/measures.h"

namespace suture {

/// Triangles of every component that repeats an earlier one exactly (the same coordinates, the same
/// orientation, whatever the numbering), in increasing order. Linear where no two components have
/// the same number of triangles.
std::vector<std::uint32_t> repeated_triangles(const Triangles& surface,
                                              const Components& components);

}  // namespace suture
