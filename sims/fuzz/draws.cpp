// Names are hashed into the seed by FNV-1a, and spread, so that similar names have nothing in
// common.
#include "sims/fuzz/draws.h"

#include <map>

namespace suture::sims {

Draws Draws::in(std::string_view part, std::uint64_t index) const {
  Draws inner(*this);
  inner.key_ = spread(mixed(fnv1a(part, key_), index));
  return inner;
}

Random Draws::of(std::string_view name) const { return Random(spread(fnv1a(name, key_))); }

double Draws::uniform(std::string_view name, double low, double high) const {
  return of(name).uniform(low, high);
}

int Draws::whole(std::string_view name, int low, int high) const {
  return low + static_cast<int>(of(name).below(static_cast<std::uint64_t>(high - low + 1)));
}

bool Draws::once_in(std::string_view name, std::uint64_t cases) const {
  return of(name).below(cases) == 0;
}

Point Draws::vector(std::string_view name, double reach) const {
  Random random = of(name);
  return {random.uniform(-reach, reach), random.uniform(-reach, reach),
          random.uniform(-reach, reach)};
}

std::string Draws::choice(std::string_view name, const std::vector<std::string>& words) const {
  const Draws lots = in(name);
  std::map<std::string, std::uint64_t> stood;
  std::string winner;
  std::uint64_t greatest = 0;
  for (const std::string& word : words) {
    const std::uint64_t lot = lots.in(word, stood[word]++).of("lot").next();
    if (!winner.empty() && lot <= greatest) continue;
    greatest = lot;
    winner = word;
  }
  return winner;
}

}  // namespace suture::sims
