// A vertex that is left acquits its body at once; only the others are measured.
#include "surgery/check/vanished.h"

#include "kernel/measure/body_loss.h"
#include "kernel/measure/measures.h"

namespace suture::surgery {

std::vector<VanishedBody> vanished_bodies(const BeforeAndAfter& surgery) {
  constexpr double kGone = 0.9;
  constexpr int kLines = 6;  // some hundred points tell what is gone from what stays
  const auto& [before, after, vertex_map] = surgery;
  const Components bodies = components(before);
  std::vector<char> stays(bodies.count, 0);
  for (std::size_t t = 0; t < before.triangles.size(); ++t)
    for (const std::uint32_t v : before.triangles[t])
      if (vertex_map[v] != kNone) stays[bodies.of_triangle[t]] = 1;
  std::vector<std::uint32_t> suspects;
  for (std::uint32_t c = 0; c < bodies.count; ++c)
    if (stays[c] == 0) suspects.push_back(c);
  std::vector<VanishedBody> vanished;
  for (const BodyLoss& loss : body_losses(before, after, {std::move(suspects), kLines}))
    if (loss.part > kGone) vanished.push_back({loss.volume, loss.centre});
  return vanished;
}

}  // namespace suture::surgery
