// Windings of whole surfaces; exact signs without the shift tell the ties.
#include "surgery/check/surgery_check.h"

#include <atomic>

#include "predicates/exact_signs.h"
#include "surgery/detect/winding.h"
#include "surgery/model/tracker_lattice.h"

namespace suture {

using namespace surgery;

namespace {

Crossings crossings_of(const Triangles& surface, const Lattice& lattice, const Oracle& oracle) {
  return find_crossings(incidence(surface), {lattice, oracle});
}

/// Answers as the filtered oracle does, and counts the answers that only the shift could give.
class TieCounter : public Oracle {
 public:
  int edge_side(const Point& p, const Point& q, const LatticePoint2& at) const override {
    const auto flat = [&](const Point& x) { return Eigen::Vector2d(x[at.u_axis], x[at.v_axis]); };
    ties_ += exact_orientation(flat(p), flat(q), {at.u, at.v}) == 0 ? 1 : 0;
    return truth_->edge_side(p, q, at);
  }
  int triangle_side(const Point& a, const Point& b, const Point& c,
                    const Point& node) const override {
    ties_ += exact_orientation(a, b, c, node) == 0 ? 1 : 0;
    return truth_->triangle_side(a, b, c, node);
  }
  int orientation(const Point& a, const Point& b, const Point& c, const Point& d) const override {
    return truth_->orientation(a, b, c, d);
  }
  std::size_t ties() const { return ties_; }

 private:
  std::unique_ptr<Oracle> truth_ = make_filtered_oracle();
  mutable std::atomic<std::size_t> ties_ = 0;
};

}  // namespace

Lattice lattice_of(const std::vector<Point>& positions, const TrackerOptions& options) {
  return tracker_lattice(positions, options);
}

struct SurfaceCheck::State {
  Winding winding;
};

SurfaceCheck::SurfaceCheck(const Triangles& surface, const Lattice& lattice, Arithmetic arithmetic)
    : state_(std::make_unique<State>(
          State{Winding(crossings_of(surface, lattice, *make_oracle(arithmetic)))})) {}
SurfaceCheck::~SurfaceCheck() = default;
SurfaceCheck::SurfaceCheck(SurfaceCheck&&) noexcept = default;

bool SurfaceCheck::marches_agree() const { return suture::marches_agree(state_->winding); }

int SurfaceCheck::winding(const Index3& node, int axis) const {
  return state_->winding.at(node, axis);
}

std::vector<Index3> SurfaceCheck::sides_changed(const SurfaceCheck& a, const SurfaceCheck& b) {
  constexpr int kAxis = 2;
  const Winding& one = a.state_->winding;
  const Winding& two = b.state_->winding;
  // Along a line both windings change at crossed edges only: what differs does so from the upper
  // node of such an edge on, and lines end outside both surfaces.
  SparseField<char> changed;
  for (const Winding* crossed : {&one, &two})
    for (const CrossedEdge& e : crossed->edges(kAxis)) {
      LatticeId id = step(e.edge, kAxis, 1);
      for (Index3 node = unpack(id); one.inside(node) != two.inside(node) && !changed.contains(id);
           id = step(id, kAxis, 1), node = unpack(id))
        changed.index(id);
    }
  std::vector<Index3> nodes;
  for (const LatticeId id : changed.keys()) nodes.push_back(unpack(id));
  return nodes;
}

std::size_t count_ties(const Triangles& surface, const Lattice& lattice) {
  std::size_t on_planes = 0;
  for (const Point& p : surface.positions)
    for (int a = 0; a < 3; ++a)  // x lies in plane(i) < x <= plane(i+1)
      on_planes += p[a] == lattice.plane(a, lattice.cell_of(a, p[a]) + 1) ? 1 : 0;
  const TieCounter oracle;
  crossings_of(surface, lattice, oracle);
  return on_planes + oracle.ties();
}

}  // namespace suture
