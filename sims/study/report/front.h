// Errors and costs of a study's runs, and the runs that no other beats in both.
#pragma once

#include "sims/study/table/row.h"

namespace suture::sims {

/// A number to be small, with what it is called and measured in.
struct Criterion {
  const char* name;
  const char* unit;  ///< "cells" are the scene's own
  double (*of)(const Row& row, double cell);
};

/// The error measures, the main one first, and the costs; `cell` is the scene's own cell size.
inline constexpr std::array<Criterion, 3> kErrors = {
    {{"mean distance", "cells",
      [](const Row& r, double c) { return r.figures.mean_distance() / c; }},
     {"largest distance", "cells",
      [](const Row& r, double c) { return r.figures.max_distance() / c; }},
     {"relative volume error", "", [](const Row& r, double) {
        return r.figures.volume_error < 0 ? -r.figures.volume_error : r.figures.volume_error;
      }}}};
inline constexpr std::array<Criterion, 2> kCosts = {
    {{"CPU seconds in the tracker", "s",
      [](const Row& r, double) { return r.figures.tracker_seconds; }},
     {"peak memory", "MB", [](const Row& r, double) { return r.figures.peak_megabytes; }}}};

/// The sound rows that no other sound row beats in one and at least equals in the other, by
/// increasing cost; of equal ones the first. Rows where either is NaN are left out.
std::vector<std::size_t> pareto_front(const std::vector<Row>& rows, const Criterion& error,
                                      const Criterion& cost);

}  // namespace suture::sims
