// Lazy exact distances: a small search tree near the region first, a full one only where that is
// not enough.
#include "surgery/detect/distance_field.h"

#include <algorithm>
#include <optional>

#include "kernel/measure/nearest_triangle.h"

namespace suture::surgery {

struct DistanceField::State {
  const Triangles& surface;
  const Lattice& lattice;
  const Winding& winding;
  std::vector<std::uint32_t> near;
  std::optional<NearestTriangle> near_tree, full_tree;
  SparseField<double> known;

  /// The distance below which only triangles in the eight cells round the node can be nearer.
  double reach(const Index3& node) const {
    double reach = std::numeric_limits<double>::infinity();
    for (int a = 0; a < 3; ++a) {
      const double here = lattice.plane(a, node[a]);
      if (node[a] > 0) reach = std::min(reach, here - lattice.plane(a, node[a] - 1));
      if (node[a] < lattice.cells(a)) reach = std::min(reach, lattice.plane(a, node[a] + 1) - here);
    }
    return reach;
  }

  double distance(const Index3& node) {
    const Point at = lattice.node(node);
    if (!near.empty()) {
      if (!near_tree) {
        Triangles some{surface.positions, {}};
        for (const std::uint32_t t : near) some.triangles.push_back(surface.triangles[t]);
        near_tree.emplace(some);
      }
      const double found = near_tree->distance(at);
      if (found <= reach(node)) return found;
    }
    if (!full_tree) full_tree.emplace(surface);
    return full_tree->distance(at);
  }
};

DistanceField::DistanceField(const Triangles& surface, const Lattice& lattice,
                             const Winding& winding)
    : state_(std::make_unique<State>(State{surface, lattice, winding, {}, {}, {}, {}})) {}
DistanceField::~DistanceField() = default;
DistanceField::DistanceField(DistanceField&&) noexcept = default;

void DistanceField::search_first(std::vector<std::uint32_t> near) {
  state_->near = std::move(near);
  state_->near_tree.reset();
}

double DistanceField::at(const Index3& node) const {
  const LatticeId id = pack(node);
  if (const double* known = state_->known.find(id)) return *known;
  const double distance = state_->distance(node);
  return state_->known[id] = state_->winding.inside(node) ? -distance : distance;
}

std::size_t DistanceField::nodes_computed() const { return state_->known.size(); }

}  // namespace suture::surgery
