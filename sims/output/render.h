// A surface drawn to a PNG file, without a display.
#pragma once

#include <string>
#include <vector>

#include "sims/output/picture.h"

namespace suture::sims {

/// Draws `surface` off-screen in a light studio look, and writes a PNG file (whole or not at all).
/// `colours` is empty or has one for each triangle. An empty surface gives an empty stage.
/// \throw InvalidInput if the options make no picture (sizes, directions), the file cannot be
/// written, or there is no way to draw here, saying what to install
void render_png(const Triangles& surface, const TriangleColours& colours,
                const PictureOptions& options, const std::filesystem::path& file);

/// One of several surfaces in a picture.
struct Panel {
  const Triangles* surface = nullptr;
  TriangleColours colours{};
  std::string label{};  ///< above it; empty: none
};
struct PanelOptions {
  int columns = 1;
};

/// Draws surfaces side by side, in rows of `columns`, each as render_png would with the same
/// options (whose width and height are one panel's). Give `fit`, or each is as large as its panel.
/// \throw InvalidInput as render_png, and if there is no panel
void render_panels(const std::vector<Panel>& panels, const PanelOptions& layout,
                   const PictureOptions& options, const std::filesystem::path& file);

}  // namespace suture::sims
