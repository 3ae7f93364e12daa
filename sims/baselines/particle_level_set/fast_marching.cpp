// Fast marching: nodes next to the surface first, then a heap of those beyond.
#include "sims/baselines/particle_level_set/fast_marching.h"

#include <algorithm>
#include <limits>
#include <queue>
#include <utility>

namespace suture::sims {
namespace {

constexpr double kFar = std::numeric_limits<double>::infinity();

/// Distance from node n to the plane through the nearest zero on its edges along each axis.
double distance_to_plane(const DenseLevelSet& set, std::size_t n) {
  const double here = set.phi[n];
  double inverse_squares = 0;
  for (int a = 0; a < 3; ++a) {
    double nearest = kFar;
    for (const std::size_t m : {n - set.box.stride(a), n + set.box.stride(a)})
      if ((set.phi[m] < 0) != (here < 0)) nearest = std::min(nearest, here / (here - set.phi[m]));
    if (nearest == 0) return 0;
    inverse_squares += 1 / (nearest * nearest);
  }
  return 1 / std::sqrt(inverse_squares);
}

/// Distance of node n, which lies next to the surface.
double closest_point(const DenseLevelSet& set, std::size_t n, const ClosestPoint& closest) {
  const double plane = distance_to_plane(set, n);
  const Index3 node = set.box.node(n);
  const Point start(node[0], node[1], node[2]);
  Point p = start;
  double phi = set.phi[n];
  for (int i = 0; i < closest.steps; ++i) {
    p -= phi * set.normal(p);
    phi = set.sample(p);
    if (std::abs(phi) > closest.tolerance) continue;
    const double distance = (p - start).norm();
    const double bound = plane + closest.drift * std::max(plane, closest.tolerance);
    return distance > 0 && distance < bound ? distance : plane;
  }
  return plane;
}

/// |φ| at the nodes next to the surface, scaled to the distances there: by the ratio of the sums
/// over a node and the mean of its neighbours across the surface. Their errors, which have opposite
/// signs where the surface is curved, cancel, and zeros between nodes with one ratio stay where
/// they are.
std::vector<double> scaled(const DenseLevelSet& set, const std::vector<std::size_t>& nodes,
                           const std::vector<double>& distances) {
  std::vector<double> result;
  for (const std::size_t n : nodes) {
    double distance = 0, phi = 0;
    int across = 0;
    for (int a = 0; a < 3; ++a)
      for (const std::size_t m : {n - set.box.stride(a), n + set.box.stride(a)})
        if ((set.phi[m] < 0) != (set.phi[n] < 0)) {
          distance += distances[m];
          phi += std::abs(set.phi[m]);
          ++across;
        }
    const double here = std::abs(set.phi[n]);
    result.push_back(here * (distances[n] + distance / across) / (here + phi / across));
  }
  return result;
}

/// The distance d with Σ max(0, d − a)² = 1 over the axes' nearer neighbours, of which those
/// that are no nearer than d do not count. \pre one is finite
double upwind(std::array<double, 3> neighbours) {
  std::sort(neighbours.begin(), neighbours.end());
  double d = neighbours[0] + 1;
  double sum = neighbours[0], squares = neighbours[0] * neighbours[0];
  for (int n = 2; n <= 3 && d > neighbours[n - 1]; ++n) {
    const double next = neighbours[n - 1];
    sum += next, squares += next * next;
    d = (sum + std::sqrt(std::max(0.0, sum * sum - n * (squares - 1)))) / n;
  }
  return d;
}

/// Distances without signs; those that are final never change again.
class March {
 public:
  explicit March(const DenseLevelSet& set)
      : box_(set.box),
        width_(set.width),
        distance_(set.box.count(), kFar),
        final_(set.box.count(), 0) {}

  void start(std::size_t n, double distance) {
    distance_[n] = distance;
    final_[n] = 1;
  }
  void run(const std::vector<std::size_t>& started) {
    for (const std::size_t n : started) look_round(n);
    while (!queue_.empty()) {
      const auto [distance, n] = queue_.top();
      queue_.pop();
      if (final_[n]) continue;
      final_[n] = 1;
      look_round(n);
    }
  }
  double distance(std::size_t n) const { return distance_[n]; }

 private:
  void look_round(std::size_t n) {
    for (int a = 0; a < 3; ++a)
      for (const std::size_t m : {n - box_.stride(a), n + box_.stride(a)})
        if (!final_[m]) update(m);
  }
  void update(std::size_t n) {
    if (on_border(n)) return;
    std::array<double, 3> neighbours;
    for (int a = 0; a < 3; ++a) {
      const std::size_t low = n - box_.stride(a), high = n + box_.stride(a);
      neighbours[a] =
          std::min(final_[low] ? distance_[low] : kFar, final_[high] ? distance_[high] : kFar);
    }
    const double d = upwind(neighbours);
    if (d < distance_[n] && d < width_) {
      distance_[n] = d;
      queue_.emplace(d, n);
    }
  }
  bool on_border(std::size_t n) const {
    const Index3 node = box_.node(n);
    for (int a = 0; a < 3; ++a)
      if (node[a] == box_.low[a] || node[a] == box_.low[a] + box_.size[a] - 1) return true;
    return false;
  }

  using Entry = std::pair<double, std::size_t>;  // equally near ones in the order of the nodes
  const NodeBox& box_;
  double width_;
  std::vector<double> distance_;
  std::vector<std::uint8_t> final_;
  std::priority_queue<Entry, std::vector<Entry>, std::greater<>> queue_;
};

}  // namespace

void march_distances(DenseLevelSet& set, const ClosestPoint& closest) {
  const std::vector<std::size_t> nodes = interface_nodes(set);
  std::vector<double> distances(set.phi.size(), kFar);
  for (const std::size_t n : nodes) distances[n] = closest_point(set, n, closest);
  const std::vector<double> starts = scaled(set, nodes, distances);
  March march(set);
  for (std::size_t i = 0; i < nodes.size(); ++i) march.start(nodes[i], starts[i]);
  march.run(nodes);
  for (std::size_t n = 0; n < set.phi.size(); ++n) {
    const double d = std::min(march.distance(n), set.width);
    // −0 would be outside
    set.phi[n] = set.phi[n] < 0 ? -std::max(d, std::numeric_limits<double>::min()) : d;
  }
}

}  // namespace suture::sims
