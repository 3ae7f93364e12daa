// Every flip and every move must raise the smallest angle near it.
#include "kernel/shapes/relax.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <tuple>

namespace suture {

namespace {

// A step must raise the sine of the smallest angle by this factor: two shapes equal up to rounding
// would otherwise be exchanged for ever.
constexpr double kGain = 1 + 1e-6;

double sine_of_smallest_angle(const Point& a, const Point& b, const Point& c) {
  const double ab = (b - a).squaredNorm(), bc = (c - b).squaredNorm(), ca = (a - c).squaredNorm();
  const double longer = std::max({ab * bc, bc * ca, ca * ab});
  return longer > 0 ? (b - a).cross(c - a).norm() / std::sqrt(longer) : 0;
}

class Patch {
 public:
  Patch(std::vector<Point>& positions, std::span<Triangle> triangles, const RelaxOptions& options)
      : p_(positions), t_(triangles), options_(options) {
    pair_halfedges();
  }

  std::size_t flip_all() {
    std::size_t flips = 0;
    for (std::uint32_t h = 0; h < opposite_.size(); ++h)
      if (h < opposite_[h] && opposite_[h] != kNone && flip(h)) ++flips;
    return flips;
  }

  /// Moves each inner vertex where that raises the worst shape round it by the factor `gain`.
  std::size_t move_all(double gain) {
    gather_stars();
    std::size_t moves = 0;
    for (std::uint32_t v = 0; v + 1 < first_.size(); ++v)
      if (first_[v] < first_[v + 1] && !on_border_[v] && move(v, gain)) ++moves;
    return moves;
  }

 private:
  static std::uint32_t next(std::uint32_t h) { return h % 3 == 2 ? h - 2 : h + 1; }
  static std::uint32_t prev(std::uint32_t h) { return h % 3 == 0 ? h + 2 : h - 1; }
  std::uint32_t source(std::uint32_t h) const { return t_[h / 3][h % 3]; }
  double shape(std::uint32_t a, std::uint32_t b, std::uint32_t c) const {
    return sine_of_smallest_angle(p_[a], p_[b], p_[c]);
  }

  void pair_halfedges() {
    std::vector<std::tuple<std::uint32_t, std::uint32_t, std::uint32_t>> edges;
    edges.reserve(3 * t_.size());
    for (std::uint32_t h = 0; h < 3 * t_.size(); ++h) {
      const std::uint32_t a = source(h), b = source(next(h));
      edges.emplace_back(std::min(a, b), std::max(a, b), h);
    }
    std::sort(edges.begin(), edges.end());
    opposite_.assign(edges.size(), kNone);
    for (std::size_t i = 1; i < edges.size(); ++i) {
      const auto& [a, b, h] = edges[i - 1];
      const auto& [c, d, g] = edges[i];
      if (a == c && b == d) join(h, g);
    }
    on_border_.assign(p_.size(), 0);
    for (std::uint32_t h = 0; h < opposite_.size(); ++h)
      if (opposite_[h] == kNone) on_border_[source(h)] = on_border_[source(next(h))] = 1;
  }

  void join(std::uint32_t h, std::uint32_t g) {
    if (h != kNone) opposite_[h] = g;
    if (g != kNone) opposite_[g] = h;
  }

  // Whether an edge joins the source of `h` to `w`. The walk goes round the fan, both ways if it is
  // open.
  bool joined(std::uint32_t h, std::uint32_t w) const {
    std::uint32_t g = h;
    do {
      if (source(next(g)) == w || source(prev(g)) == w) return true;
      g = opposite_[prev(g)];
    } while (g != kNone && g != h);
    if (g == h) return false;
    for (g = opposite_[h]; g != kNone; g = opposite_[next(g)])
      if (source(prev(g)) == w) return true;
    return false;
  }

  bool flip(std::uint32_t h) {
    const std::uint32_t g = opposite_[h];
    const std::uint32_t a = source(h), b = source(g), c = source(prev(h)), d = source(prev(g));
    const double now = std::min(shape(a, b, c), shape(b, a, d));
    if (std::min(shape(a, d, c), shape(d, b, c)) <= now * kGain || joined(prev(h), d) ||
        !options_.admissible(p_[a], p_[d], p_[c]) || !options_.admissible(p_[d], p_[b], p_[c]))
      return false;
    const std::uint32_t bc = opposite_[next(h)], ca = opposite_[prev(h)], ad = opposite_[next(g)],
                        db = opposite_[prev(g)];
    const std::uint32_t s = 3 * (h / 3), t = 3 * (g / 3);
    t_[h / 3] = {a, d, c};
    t_[g / 3] = {d, b, c};
    join(s, ad);
    join(s + 1, t + 2);
    join(s + 2, ca);
    join(t, db);
    join(t + 1, bc);
    return true;
  }

  void gather_stars() {
    first_.assign(p_.size() + 1, 0);
    for (const Triangle& t : t_)
      for (const std::uint32_t v : t) ++first_[v + 1];
    for (std::size_t v = 1; v < first_.size(); ++v) first_[v] += first_[v - 1];
    star_.resize(3 * t_.size());
    std::vector<std::uint32_t> fill(first_.begin(), first_.end() - 1);
    for (std::uint32_t h = 0; h < star_.size(); ++h) star_[fill[source(h)]++] = h;
  }

  std::span<const std::uint32_t> star(std::uint32_t v) const {
    return {star_.data() + first_[v], first_[v + 1] - first_[v]};
  }

  double worst_shape(std::uint32_t v, const Point& at) const {
    double worst = 1;
    for (const std::uint32_t h : star(v))
      worst = std::min(worst, sine_of_smallest_angle(at, p_[source(next(h))], p_[source(prev(h))]));
    return worst;
  }

  bool may_be_at(std::uint32_t v, const Point& at) const {
    for (const std::uint32_t h : star(v))
      if (!options_.admissible(at, p_[source(next(h))], p_[source(prev(h))])) return false;
    return true;
  }

  bool move(std::uint32_t v, double gain) {
    Point mean = Point::Zero();
    for (const std::uint32_t h : star(v)) mean += p_[source(next(h))];
    mean /= static_cast<double>(star(v).size());
    const double now = worst_shape(v, p_[v]);
    for (const double step : {1.0, 0.5, 0.25}) {
      const Point to = options_.project(p_[v] + step * (mean - p_[v]));
      if (worst_shape(v, to) <= now * gain || !may_be_at(v, to)) continue;
      p_[v] = to;
      return true;
    }
    return false;
  }

  std::vector<Point>& p_;
  std::span<Triangle> t_;
  const RelaxOptions& options_;
  std::vector<std::uint32_t> opposite_;      // halfedge 3t+i leaves vertex i of triangle t
  std::vector<std::uint32_t> first_, star_;  // halfedges that leave each vertex
  std::vector<char> on_border_;
};

}  // namespace

void relax(std::vector<Point>& positions, std::span<Triangle> triangles,
           const RelaxOptions& options) {
  Patch patch(positions, triangles, options);
  for (int sweep = 0; sweep < options.even_sweeps; ++sweep) {
    patch.move_all(0);
    patch.flip_all();
  }
  for (int sweep = 0; sweep < options.sweeps; ++sweep) {
    const std::size_t flips = patch.flip_all();
    if (flips + patch.move_all(kGain) == 0) return;
  }
}

}  // namespace suture
