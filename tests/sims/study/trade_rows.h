// Rows of a study, planted for the tests of what is made of them.
#pragma once

#include "sims/study/table/trade_row.h"

namespace suture {

using namespace suture::sims;

/// A sound row: where it stands between cost and error.
inline Row planted(int run, double seconds, double error, const std::string& design = "grid") {
  Row row = trade_row({{"passes", std::to_string(run)}});
  row.set("run", std::to_string(run));
  row.set("design", design);
  row.set("change", design == "own" ? "" : "passes=" + std::to_string(run));
  row.set("outcome", kDoneRun);
  row.set("repeats", "1");
  row.set("tracker_seconds", seconds);
  row.set("total_seconds", seconds);
  row.set("peak_megabytes", 100 - seconds);
  for (const char* mean : {"mean_distance_forth", "mean_distance_back"}) row.set(mean, error);
  for (const char* max : {"max_distance_forth", "max_distance_back"}) row.set(max, 5 * error);
  row.set("volume_error", -error);
  row.set("components", 1.0);
  row.set("euler", 2.0);
  row.set("self_intersecting_pairs", 0.0);
  row.set("topology_right", 1.0);
  return row;
}

/// A run that was lost: it has seconds and no error.
inline Row planted_crash(int run, double seconds) {
  Row row = planted(run, seconds, kUnknown);
  row.set("outcome", kCrashedRun);
  row.set("failure", "killed by signal 11 (Segmentation fault)");
  row.set("topology_right", kUnknown);
  return row;
}

/// The cheapest (1), one that another beats (2), the scene's own (3), a better and cheaper one than
/// that (4), the best (5), and a better one still with the wrong topology (6), refused (7), lost
/// (8).
inline std::vector<Row> planted_study() {
  std::vector<Row> rows = {planted(1, 1, 0.8),  planted(2, 2, 0.9), planted(3, 4, 0.4, "own"),
                           planted(4, 3, 0.3),  planted(5, 9, 0.1), planted(6, 2, 0.01, "passes"),
                           planted(7, 2, 0.01), planted_crash(8, 5)};
  rows[5].set("topology_right", 0.0);
  rows[5].set("components", 3.0);
  rows[6].set("outcome", kRefusedRun);
  rows[6].set("failure", "cut: \"an edge\", twice\nused");
  rows[6].set("refused", 2.0);
  rows[6].set("remodels", 7.0);
  return rows;
}

}  // namespace suture
