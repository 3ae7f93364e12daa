// A slow check costs a remodel or more, so a sample of the seeds has to do.
#include "sims/fuzz/checks.h"

#include <algorithm>

#include "kernel/errors.h"
#include "kernel/random.h"
#include "sims/fuzz/surface_checks.h"
#include "sims/fuzz/twin_checks.h"
#include "sims/support/keys.h"

namespace suture::sims {

namespace {

constexpr std::uint64_t kSampled = 64;  // one seed in so many is asked the slow checks

}  // namespace

const std::vector<FuzzCheck>& fuzz_checks() {
  static const std::vector<FuzzCheck> checks = {{"audit", CheckCost::fast, check_audit},
                                                {"bits", CheckCost::fast, check_bits},
                                                {"map", CheckCost::fast, check_map},
                                                {"marches", CheckCost::fast, check_marches},
                                                {"invariance", CheckCost::fast, check_invariance},
                                                {"settled", CheckCost::fast, check_settled},
                                                {"solid_angle", CheckCost::slow, check_solid_angle},
                                                {"rational", CheckCost::slow, check_rational},
                                                {"scaling", CheckCost::slow, check_scaling},
                                                {"axes", CheckCost::slow, check_axes},
                                                {"cells", CheckCost::slow, check_cells},
                                                {"order", CheckCost::slow, check_order}};
  return checks;
}

CheckChoice::CheckChoice(const std::string& words) : words_(words) {
  if (words == "sampled" || words == "fast" || words == "all") return;
  std::vector<std::string> known;
  for (const FuzzCheck& check : fuzz_checks()) known.emplace_back(check.name);
  for (std::size_t from = 0; from <= words.size();) {
    const std::size_t comma = std::min(words.find(',', from), words.size());
    names_.push_back(words.substr(from, comma - from));
    if (std::find(known.begin(), known.end(), names_.back()) == known.end())
      throw InvalidInput("there is no check \"" + names_.back() +
                         "\"; give sampled, fast, all, or some of " + joined(known));
    from = comma + 1;
  }
}

bool CheckChoice::asks(const FuzzCheck& check, std::uint64_t seed) const {
  if (!names_.empty()) return std::find(names_.begin(), names_.end(), check.name) != names_.end();
  if (check.cost == CheckCost::fast || words_ == "all") return true;
  return words_ == "sampled" && Random(~seed).below(kSampled) == 0;
}

}  // namespace suture::sims
