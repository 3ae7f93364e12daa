// A surface drawn to a PNG file, without a display.
#pragma once

#include "sims/output/picture.h"

namespace suture {

/// Draws `surface` off-screen in a light studio look, and writes a PNG file (whole or not at all).
/// `colours` is empty or has one for each triangle. An empty surface gives an empty stage.
/// \throw InvalidInput if the options make no picture (sizes, directions), the file cannot be
/// written, or there is no way to draw here, saying what to install
void render_png(const Triangles& surface, const TriangleColours& colours,
                const PictureOptions& options, const std::filesystem::path& file);

}  // namespace suture
