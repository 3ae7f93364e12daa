// Lines along each axis are cut by both surfaces, and each place counts by the normal near it.
#include "kernel/measure/symmetric_difference.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <span>
#include <string>

#include "kernel/errors.h"
#include "kernel/measure/line_cuts.h"
#include "kernel/measure/nearest_triangle.h"

namespace suture {
namespace {

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
  double over(const LineGrid& g, const Stretch& stretch) const {
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
double only_one(std::span<const LineCut> line, const LineGrid& grid, const Weights& weights) {
  std::array<int, 2> winding{0, 0};
  double length = 0, last = 0;
  for (const LineCut& cut : line) {
    if ((winding[0] >= 1) != (winding[1] >= 1) && cut.height > last)
      length += weights.over(grid, {cut.line, last, cut.height});
    last = cut.height;
    winding[cut.surface] += cut.step;
  }
  return winding[0] == 0 && winding[1] == 0 ? length : -1;
}

void add_lines(std::vector<LineCut> cuts, const LineGrid& grid, const Weights& weights,
               Quarters& sums) {
  sort_along(cuts);
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
    const LineGrid grid = grid_along(axis, box, result.spacing);
    std::vector<LineCut> cuts;
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
