// Lines along each axis are cut by both surfaces, and each place counts by the normal near it.
#include "kernel/measure/symmetric_difference.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <span>
#include <string>
#include <tuple>

#include "kernel/errors.h"
#include "kernel/lattice.h"
#include "kernel/measure/nearest_triangle.h"

namespace suture {
namespace {

// Where the grid of each axis begins, in spacings. With these offsets no line runs along edges of a
// regular mesh, and no two axes see a symmetric body alike.
constexpr std::array<double, 3> kOffset1 = {0.38196601125010515, 0.7639320225002103, 0.14589803375},
                                kOffset2 = {0.24512233375330728, 0.8301597090, 0.5698402909980};

/// A grid of lines along one axis: a line is a point of the plane of the other two.
struct Grid {
  int along, across1, across2;
  double low1, low2, spacing;
  std::int64_t count1, count2;

  double first(std::int64_t i) const {
    return low1 + (static_cast<double>(i) + kOffset1[along]) * spacing;
  }
  double second(std::int64_t j) const {
    return low2 + (static_cast<double>(j) + kOffset2[along]) * spacing;
  }
};

struct Cut {
  std::int64_t line;
  double height;
  int surface, step;  ///< the winding changes by `step` along the line
};

/// Cuts the lines of a grid by the triangles of one surface.
struct Cutter {
  const Triangles& s;
  const Grid& g;
  int surface;

  /// Twice the area of (a, b) and the line at (x, y), computed alike from both triangles of the
  /// edge and never zero: a line that meets an edge is on the same side of it for both.
  double side(std::array<std::uint32_t, 2> edge, double x, double y) const {
    const auto [a, b] = edge;
    const bool swapped = a > b;
    const Point &p = s.positions[swapped ? b : a], &q = s.positions[swapped ? a : b];
    const double area = (q[g.across1] - p[g.across1]) * (y - p[g.across2]) -
                        (q[g.across2] - p[g.across2]) * (x - p[g.across1]);
    const double decided = area == 0 ? std::numeric_limits<double>::min() : area;
    return swapped ? -decided : decided;
  }

  void cut(const Triangle& t, std::vector<Cut>& cuts) const {
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
        const double height =
            (wa * a[g.along] + wb * b[g.along] + wc * c[g.along]) / (wa + wb + wc);
        cuts.push_back({i * g.count2 + j, height, surface, up ? -1 : 1});
      }
  }
};

/// A part of a line.
struct Stretch {
  std::int64_t line;
  double from, to;
};

/// The sum over a quarter of the lines, which are every other one along both axes.
struct Sum {
  double length = 0;
  std::size_t lines = 0, skipped = 0;
};
using Quarters = std::array<Sum, 4>;

/// The weight of a place for the lines of an axis: the square of that component of the normal of
/// the nearest triangle. The weights of the three axes add up to 1, whatever the normal is; a thin
/// sheet is left to the lines that cross it steeply, and grazing ones count little.
class Weights {
 public:
  explicit Weights(const Triangles& surface) : nearest_(surface) {
    for (const auto& [a, b, c] : surface.triangles) {
      const auto& x = surface.positions;
      const Point n = (x[b] - x[a]).cross(x[c] - x[a]);
      const double length = n.stableNorm();
      squares_.push_back(length > 0 ? Point((n / length).cwiseAbs2()) : Point::Constant(1.0 / 3));
    }
  }
  /// The integral over a stretch of a line, by the middles of equal parts, at most 32 and no longer
  /// than two spacings where that is enough.
  double over(const Grid& g, const Stretch& stretch) const {
    const auto [line, from, to] = stretch;
    const double step = 2 * g.spacing;
    const double parts = std::clamp(std::ceil((to - from) / step), 1.0, 32.0);
    Point p;
    p[g.across1] = g.first(line / g.count2);
    p[g.across2] = g.second(line % g.count2);
    double sum = 0;
    for (double i = 0; i < parts; ++i) {
      p[g.along] = from + (i + 0.5) / parts * (to - from);
      sum += squares_[nearest_.triangle(p)][g.along];
    }
    return sum / parts * (to - from);
  }

 private:
  NearestTriangle nearest_;
  std::vector<Point> squares_;
};

/// The weighted length of one line on which only one surface is; negative if a surface is not
/// closed there.
double only_one(std::span<const Cut> line, const Grid& grid, const Weights& weights) {
  std::array<int, 2> winding{0, 0};
  double length = 0, last = 0;
  for (const Cut& cut : line) {
    if ((winding[0] >= 1) != (winding[1] >= 1) && cut.height > last)
      length += weights.over(grid, {cut.line, last, cut.height});
    last = cut.height;
    winding[cut.surface] += cut.step;
  }
  return winding[0] == 0 && winding[1] == 0 ? length : -1;
}

void add_lines(std::vector<Cut> cuts, const Grid& grid, const Weights& weights, Quarters& sums) {
  std::sort(cuts.begin(), cuts.end(), [](const Cut& a, const Cut& b) {
    return std::tie(a.line, a.height, a.surface, a.step) <
           std::tie(b.line, b.height, b.surface, b.step);
  });
  for (std::size_t from = 0; from < cuts.size();) {
    std::size_t to = from;
    while (to < cuts.size() && cuts[to].line == cuts[from].line) ++to;
    const double length = only_one({cuts.data() + from, to - from}, grid, weights);
    const std::int64_t i = cuts[from].line / grid.count2, j = cuts[from].line % grid.count2;
    Sum& sum = sums[2 * (i % 2) + j % 2];
    ++sum.lines;
    if (length < 0)
      ++sum.skipped;
    else
      sum.length += length;
    from = to;
  }
}

Grid grid_along(int axis, const Box& box, double spacing) {
  const int u = (axis + 1) % 3, v = (axis + 2) % 3;
  const auto count = [&](int k) {
    return static_cast<std::int64_t>((box.high[k] - box.low[k]) / spacing) + 1;
  };
  return {axis, u, v, box.low[u], box.low[v], spacing, count(u), count(v)};
}

}  // namespace

SymmetricDifference symmetric_difference(const Triangles& a, const Triangles& b,
                                         const LineOptions& options) {
  if (options.lines < 1 || options.lines > 100000)
    throw InvalidInput("a difference is measured along 1 to 100000 lines a side, not " +
                       std::to_string(options.lines));
  std::vector<Point> all = a.positions;
  all.insert(all.end(), b.positions.begin(), b.positions.end());
  SymmetricDifference result;
  if (all.empty()) return result;
  const Box box = bounding_box(all);
  result.spacing = (box.high - box.low).maxCoeff() / options.lines;
  if (!(result.spacing > 0)) return result;
  const Weights weights(a.triangles.empty() ? b : a);
  Quarters sums;
  for (int axis = 0; axis < 3; ++axis) {
    const Grid grid = grid_along(axis, box, result.spacing);
    std::vector<Cut> cuts;
    for (const Triangle& t : a.triangles) Cutter{a, grid, 0}.cut(t, cuts);
    for (const Triangle& t : b.triangles) Cutter{b, grid, 1}.cut(t, cuts);
    add_lines(std::move(cuts), grid, weights, sums);
  }
  std::array<double, 4> volumes{};
  for (int i = 0; i < 4; ++i) {
    result.lines += sums[i].lines;
    result.skipped += sums[i].skipped;
    volumes[i] = 4 * sums[i].length * result.spacing * result.spacing;
    result.volume += volumes[i] / 4;
  }
  for (const double v : volumes)
    result.error += (v - result.volume) * (v - result.volume) / (4 * 3);
  result.error = std::sqrt(result.error);
  return result;
}

}  // namespace suture
