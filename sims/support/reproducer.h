// The mesh of a refused surgery, saved for whoever looks into it.
#pragma once

#include <filesystem>

#include "kernel/triangles.h"

namespace suture::sims {

/// Saves the surface that remodel number `number` (from 1) of a run refused, as
/// refused_remodel_NUMBER.ply in `folder`, which is made. \return the file
/// \throw InvalidInput if it cannot be written
std::filesystem::path save_reproducer(const std::filesystem::path& folder, std::size_t number,
                                      const Triangles& surface);

}  // namespace suture::sims
