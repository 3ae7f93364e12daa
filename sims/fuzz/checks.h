// The checks: what must hold after every operation, by name, and which of them a campaign asks.
#pragma once

#include <string>
#include <vector>

#include "sims/fuzz/observation.h"

namespace suture::sims {

enum class CheckCost {
  fast,  ///< asked always
  slow   ///< asked on one seed in 64, unless it is asked for by name
};

struct FuzzCheck {
  const char* name;
  CheckCost cost;
  Objection (*object)(const Observation&);
};

/// All checks but those that the runner itself makes: exception, refused, crash, hang.
const std::vector<FuzzCheck>& fuzz_checks();

/// The checks that a campaign asks: "sampled" (the fast ones always, the slow ones on one seed in
/// 64, by the seed), "fast", "all", or names joined by commas, which are then asked always.
class CheckChoice {
 public:
  /// \throw InvalidInput for a name that is not known
  explicit CheckChoice(const std::string& words = "sampled");

  bool asks(const FuzzCheck& check, std::uint64_t seed) const;
  const std::string& words() const { return words_; }

 private:
  std::string words_;
  std::vector<std::string> names_;
};

}  // namespace suture::sims
