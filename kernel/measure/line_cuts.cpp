// A line that meets an edge is on the same side of it for both triangles of the edge.
#include "kernel/measure/line_cuts.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <tuple>

namespace suture {

LineGrid grid_along(int axis, const Box& box, double spacing) {
  const int u = (axis + 1) % 3, v = (axis + 2) % 3;
  const auto count = [&](int k) {
    return static_cast<std::int64_t>((box.high[k] - box.low[k]) / spacing) + 1;
  };
  return {axis, u, v, box.low[u], box.low[v], spacing, count(u), count(v)};
}

/// Twice the area of (a, b) and the line at (x, y), computed alike from both triangles of the
/// edge and never zero.
double Cutter::side(std::array<std::uint32_t, 2> edge, double x, double y) const {
  const auto [a, b] = edge;
  const bool swapped = a > b;
  const Point &p = s.positions[swapped ? b : a], &q = s.positions[swapped ? a : b];
  const double area = (q[g.across1] - p[g.across1]) * (y - p[g.across2]) -
                      (q[g.across2] - p[g.across2]) * (x - p[g.across1]);
  const double decided = area == 0 ? std::numeric_limits<double>::min() : area;
  return swapped ? -decided : decided;
}

void Cutter::cut(const Triangle& t, std::vector<LineCut>& cuts) const {
  const Point &a = s.positions[t[0]], &b = s.positions[t[1]], &c = s.positions[t[2]];
  const auto range = [&](int axis, double low, double offset, std::int64_t count) {
    const double least = std::min({a[axis], b[axis], c[axis]}),
                 most = std::max({a[axis], b[axis], c[axis]});
    const double from = std::ceil((least - low) / g.spacing - offset - 1e-9),
                 to = std::floor((most - low) / g.spacing - offset + 1e-9);
    return std::pair(std::max<std::int64_t>(0, static_cast<std::int64_t>(from)),
                     std::min(count - 1, static_cast<std::int64_t>(to)));
  };
  const auto [i0, i1] = range(g.across1, g.low1, kOffset1[g.along], g.count1);
  const auto [j0, j1] = range(g.across2, g.low2, kOffset2[g.along], g.count2);
  for (std::int64_t i = i0; i <= i1; ++i)
    for (std::int64_t j = j0; j <= j1; ++j) {
      const double x = g.first(i), y = g.second(j);
      const double wc = side({t[0], t[1]}, x, y), wa = side({t[1], t[2]}, x, y),
                   wb = side({t[2], t[0]}, x, y);
      const bool up = wa > 0 && wb > 0 && wc > 0;
      if (!up && !(wa < 0 && wb < 0 && wc < 0)) continue;
      const double height = (wa * a[g.along] + wb * b[g.along] + wc * c[g.along]) / (wa + wb + wc);
      cuts.push_back({i * g.count2 + j, height, surface, up ? -1 : 1});
    }
}

void sort_along(std::vector<LineCut>& cuts) {
  std::sort(cuts.begin(), cuts.end(), [](const LineCut& a, const LineCut& b) {
    return std::tie(a.line, a.height, a.surface, a.step) <
           std::tie(b.line, b.height, b.surface, b.step);
  });
}

}  // namespace suture
