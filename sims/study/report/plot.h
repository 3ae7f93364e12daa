// A study's plots: a gnuplot script beside the table, and the pictures that it makes.
#pragma once

#include <filesystem>

#include "sims/study/table/trade_row.h"

namespace suture::sims {

/// The plots need more than the rows.
struct PlotOptions {
  std::string title;
  double cell_size = 1;   ///< the scene's own: distances are drawn in it
  std::string reference;  ///< what errors are against, for the captions
};

/// A script that draws error_seconds.png and error_memory.png (every run, failures marked, the
/// front of the sound ones) and choices.png (each choice beside the scene's own), in the folder
/// that gnuplot runs in. The rows are in it: it can be changed and run again on its own.
std::string plot_script(const std::vector<Row>& rows, const PlotOptions& options);

/// Writes trade.gp to `folder` and has gnuplot run it. \return empty, or why there are no pictures
/// and what to do
std::string draw(const std::vector<Row>& rows, const PlotOptions& options,
                 const std::filesystem::path& folder);

}  // namespace suture::sims
