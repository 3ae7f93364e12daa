// From a seed to a case: the same case for the same seed, everywhere.
#pragma once

#include <optional>

#include "sims/fuzz/fuzz_case.h"

namespace suture::sims {

/// What cases are like.
enum class Profile {
  random,    ///< bodies as they come, moved and remodelled a few times
  hostile,   ///< vertices on planes, lines, nodes and beside them; extreme scales and offsets
  fed_back,  ///< output fed back many times, moved a little in between
  all        ///< one of these, by the seed
};

inline constexpr std::array<Named<Profile>, 4> kProfileNames = {{{"random", Profile::random},
                                                                 {"hostile", Profile::hostile},
                                                                 {"fed_back", Profile::fed_back},
                                                                 {"all", Profile::all}}};

/// What a campaign asks of its cases; whatever is not given the seed decides.
struct CaseOptions {
  Profile profile = Profile::all;
  Arithmetic arithmetic = Arithmetic::filtered;
  std::optional<Collapse> collapse{};
  std::optional<double> jitter{};
};

FuzzCase make_case(std::uint64_t seed, const CaseOptions& options);

}  // namespace suture::sims
