// A study's table in words: what to choose, what it costs, what fails.
#pragma once

#include "sims/study/table/trade_row.h"

namespace suture::sims {

struct RecommendOptions {
  std::string title, reference;
  std::string topology = "the reference";  ///< whose topology is right, in words
  double cell_size = 1;                    ///< the scene's own
};

/// The sound row with the least mean distance; of equal ones the cheapest; null if there is none.
const Row* least_error(const std::vector<Row>& rows);

/// The cheapest sound row whose mean distance, largest distance, volume error and self-intersecting
/// pairs are none above those of `than`; `than` itself if there is no cheaper one.
const Row* as_good_for_less(const std::vector<Row>& rows, const Row& than);

/// A page in Markdown. Seconds are CPU seconds in the tracker.
std::string recommendation(const std::vector<Row>& rows, const RecommendOptions& options);

}  // namespace suture::sims
