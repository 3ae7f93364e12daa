// Owns the surface, its lattice and its windings, so that the field may outlive the tracker's next
// step.
#include "surgery/detect/surface_distance.h"

#include <optional>

#include "surgery/detect/complex_cells.h"
#include "surgery/detect/distance_field.h"
#include "surgery/model/tracker_lattice.h"

namespace suture {

using namespace surgery;

struct SurfaceDistance::State {
  Triangles surface;
  Lattice lattice;
  Crossings crossings;
  Winding winding;
  DistanceField field;
  std::optional<std::vector<Index3>> nodes;

  State(const Triangles& s, const TrackerOptions& o)
      : surface(s),
        lattice(tracker_lattice(s.positions, o)),
        crossings(find_crossings(incidence(s), {lattice, *make_oracle(o.arithmetic)})),
        winding(crossings),
        field(surface, lattice, winding) {}
};

SurfaceDistance::SurfaceDistance(const Triangles& surface, const TrackerOptions& options)
    : state_(std::make_unique<State>(surface, options)) {}
SurfaceDistance::~SurfaceDistance() = default;
SurfaceDistance::SurfaceDistance(SurfaceDistance&&) noexcept = default;

const Lattice& SurfaceDistance::lattice() const { return state_->lattice; }

const std::vector<Index3>& SurfaceDistance::surface_nodes() const {
  if (!state_->nodes) {
    SparseField<char> corners;
    const CellSet set = find_complex_cells(state_->crossings, state_->winding);
    for (const LatticeId cell : set.cells.keys())
      for (int corner = 0; corner < 8; ++corner)
        corners.index(step(step(step(cell, 0, corner & 1), 1, corner >> 1 & 1), 2, corner >> 2));
    state_->nodes.emplace();
    for (const LatticeId id : corners.keys()) state_->nodes->push_back(unpack(id));
  }
  return *state_->nodes;
}

double SurfaceDistance::at(const Index3& node) const { return state_->field.at(node); }
std::size_t SurfaceDistance::computed() const { return state_->field.nodes_computed(); }

}  // namespace suture
