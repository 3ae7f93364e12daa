// Errors and costs of a study's runs, and the runs that no other beats in both.
#pragma once

#include <array>

#include "sims/study/table/trade_row.h"

namespace suture::sims {

/// A number to be small, with what it is called and measured in.
struct Criterion {
  const char* name;
  const char* unit;  ///< "cells" are the scene's own
  double (*of)(const Row& row, double cell);
};

/// The error measures, the main one first, and the costs; `cell` is the scene's own cell size.
inline constexpr std::array<Criterion, 3> kErrors = {
    {{"mean distance", "cells", [](const Row& r, double c) { return mean_distance(r) / c; }},
     {"largest distance", "cells", [](const Row& r, double c) { return max_distance(r) / c; }},
     {"relative volume error", "", [](const Row& r, double) { return volume_error(r); }}}};
inline constexpr std::array<Criterion, 2> kCosts = {
    {{"CPU seconds in the tracker", "s", [](const Row& r, double) { return tracker_seconds(r); }},
     {"peak memory", "MB", [](const Row& r, double) { return r.number("peak_megabytes"); }}}};

/// The sound rows that no other sound row beats in one and at least equals in the other, by
/// increasing cost; of equal ones the first. Rows where either is NaN are left out.
std::vector<std::size_t> pareto_front(const std::vector<Row>& rows, const Criterion& error,
                                      const Criterion& cost);

}  // namespace suture::sims
