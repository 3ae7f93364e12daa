// Stand-ins for what a campaign runs, and summaries that can be compared.
#pragma once

#include <nlohmann/json.hpp>

#include "sims/fuzz/case_maker.h"
#include "sims/fuzz/execute.h"

namespace suture::sims {

/// A stand-in for a case that does nothing but count.
inline FuzzSummary counted(std::uint64_t seed) {
  FuzzSummary one;
  one.cases = 1;
  one.surgeries = 2;
  one.digest = seed * seed;
  one.refused["a cause"] = 1;
  return one;
}

inline FuzzSummary real(std::uint64_t seed) {
  return run_case(make_case(seed, {}), CheckChoice("fast")).counts;
}

inline nlohmann::json without_seconds(const FuzzSummary& summary) {
  nlohmann::json json = to_json(summary);
  for (const char* key :
       {"cpu_seconds", "wall_seconds", "surgeries_per_second", "surgeries_per_cpu_second"})
    json.erase(key);
  return json;
}

}  // namespace suture::sims
