// Rows of a study, planted for the tests of what is made of them.
#pragma once

#include "sims/study/table/row.h"

namespace suture {

using namespace suture::sims;

/// A sound row: where it stands between cost and error.
inline Row planted(int run, double seconds, double error, const std::string& design = "grid") {
  Row row;
  row.run = run;
  row.design = design;
  row.change = design == "own" ? "" : "passes=" + std::to_string(run);
  row.settings = {{"passes", std::to_string(run)}};
  row.outcome = kDoneRun;
  row.repeats = 1;
  Figures& f = row.figures;
  f.tracker_seconds = f.total_seconds = seconds;
  f.peak_megabytes = 100 - seconds;
  f.mean_forth = f.mean_back = error;
  f.max_forth = f.max_back = 5 * error;
  f.volume_error = -error;
  f.components = 1;
  f.euler = 2;
  f.intersecting_pairs = 0;
  f.topology_right = 1;
  return row;
}

/// A run that was lost: it has seconds and no error.
inline Row planted_crash(int run, double seconds) {
  Row row = planted(run, seconds, kUnknownFigure);
  row.outcome = kCrashedRun;
  row.failure = "killed by signal 11 (Segmentation fault)";
  row.figures.topology_right = kUnknownFigure;
  return row;
}

}  // namespace suture
