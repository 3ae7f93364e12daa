// What several effects ask of one projection, added up.
#include "sims/fluid/effects/effect.h"

#include <utility>

namespace suture::sims {
namespace {

void add(std::vector<double>& to, std::vector<double> more) {
  if (to.empty()) {
    to = std::move(more);
    return;
  }
  for (std::size_t n = 0; n < to.size(); ++n) to[n] += more[n];
}

}  // namespace

void ProjectionTerms::add_jump(std::array<std::vector<double>, 3> more) {
  for (int a = 0; a < 3; ++a) add(jump[a], std::move(more[a]));
}

void ProjectionTerms::add_divergence(std::vector<double> more) { add(divergence, std::move(more)); }

}  // namespace suture::sims
