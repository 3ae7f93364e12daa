// The liquid on a grid, and continued into the solids it touches.
#include <algorithm>
#include <cmath>
#include <memory>

#include "kernel/lists.h"
#include "kernel/measure/nearest_triangle.h"
#include "sims/fluid/liquid/liquid.h"

namespace suture::sims {
namespace {

/// A triangle so near a wall, in cells, is none whose plane the surface has: it lies along the
/// wall, or is one of those that round off the edge where the surface meets it.
constexpr double kTouching = 0.25;

/// A little further from it, one that faces the wall within 60° lies along it.
constexpr double kFacing = -0.5;

/// The normal of a wall is taken over this part of a cell.
constexpr double kNormalStep = 0.01;

/// The triangles near solids that do not lie along them: the surface that has a pressure.
class FreeSurface {
 public:
  FreeSurface(const Triangles& surface, const Solids& solids, double t, double h) : h_(h) {
    const double reach = (2 * kNear + 1) * h;
    for (const Triangle& triangle : surface.triangles) {
      const std::array<Point, 3> corner{surface.positions[triangle[0]],
                                        surface.positions[triangle[1]],
                                        surface.positions[triangle[2]]};
      const Point middle = (corner[0] + corner[1] + corner[2]) / 3;
      const double d = solids.distance(middle, t);
      if (d > reach || d <= kTouching * h) continue;
      const Point across = (corner[1] - corner[0]).cross(corner[2] - corner[0]);
      if (across.stableNorm() == 0) continue;
      if (d <= kThinnestAir * h &&
          across.stableNormalized().dot(solids.normal(middle, t, kNormalStep * h)) < kFacing)
        continue;
      const auto first = static_cast<std::uint32_t>(free_.positions.size());
      free_.triangles.push_back({first, first + 1, first + 2});
      free_.positions.insert(free_.positions.end(), corner.begin(), corner.end());
    }
    if (!free_.triangles.empty()) nearest_ = std::make_unique<NearestTriangle>(free_);
  }

  /// The plane of the nearest triangle, if one is within kNear cells.
  bool plane(const Point& p, Eigen::Hyperplane<double, 3>& found) const {
    if (nearest_ == nullptr || nearest_->distance(p) > kNear * h_) return false;
    const Triangle& t = free_.triangles[nearest_->triangle(p)];
    const Point& a = free_.positions[t[0]];
    const Point across = (free_.positions[t[1]] - a).cross(free_.positions[t[2]] - a);
    found = Eigen::Hyperplane<double, 3>(across.stableNormalized(), a);
    return true;
  }

 private:
  double h_;
  Triangles free_;
  std::unique_ptr<NearestTriangle> nearest_;
};

using Plane = Eigen::Hyperplane<double, 3>;

/// A cell whose D was made from a plane: the ways to its neighbours cross that, not what of the
/// surface lies along the solid.
struct Continued {
  Slot slot;
  Plane plane;
};

/// Where D is the liquid's continued; `near`: a slot of the grid each.
std::vector<Continued> continue_into(Liquid& liquid, const std::vector<std::uint8_t>& near,
                                     const Triangles& surface, const Solids& solids, double t) {
  const SparseGrid& grid = *liquid.grid;
  const double h = grid.h(), thinnest = kThinnestAir * h;
  std::vector<Continued> continued;
  const FreeSurface free(surface, solids, t, h);
  for (Slot s = 0; s < grid.size(); ++s) {
    if (near[s] == 0) continue;
    const Point p = grid.centre(grid.cell(s));
    const double to_solid = solids.distance(p, t), to_liquid = liquid.distance[s];
    const bool in_solid = to_solid <= 0;
    if (to_liquid < 0 ? !in_solid : to_solid + to_liquid > thinnest) continue;
    Plane plane;
    if (free.plane(p, plane)) {
      liquid.distance[s] = plane.signedDistance(p);
      continued.push_back({s, plane});
    } else {
      liquid.distance[s] = -h / 2;
    }
  }
  return continued;
}

/// Replaces what is said of a face, or adds it.
void set_crossing(std::vector<FaceCrossing>& crossings, std::vector<FaceCrossing>& added,
                  const FaceCrossing& crossing) {
  const auto at = std::lower_bound(crossings.begin(), crossings.end(), crossing.face,
                                   [](const FaceCrossing& c, Slot face) { return c.face < face; });
  if (at != crossings.end() && at->face == crossing.face)
    *at = crossing;
  else
    added.push_back(crossing);
}

void cross_planes(Liquid& liquid, const std::vector<Continued>& continued) {
  const SparseGrid& grid = *liquid.grid;
  for (int axis = 0; axis < 3; ++axis) {
    std::vector<FaceCrossing> added;
    for (const Continued& c : continued)
      for (const int side : {-1, 1}) {
        const Slot n = grid.neighbour(c.slot, axis, side);
        if (n == kNoSlot || liquid.inside(n) == liquid.inside(c.slot)) continue;
        const double here = liquid.distance[c.slot];
        const double there = c.plane.signedDistance(grid.centre(grid.cell(n)));
        if ((here < 0) == (there < 0)) continue;
        const double way = here / (here - there), up = side > 0 ? way : 1 - way;
        set_crossing(liquid.crossings[axis], added, {side > 0 ? n : c.slot, up, up});
      }
    std::vector<FaceCrossing>& all = liquid.crossings[axis];
    all.insert(all.end(), added.begin(), added.end());
    const auto before = [](const FaceCrossing& a, const FaceCrossing& b) {
      return a.face < b.face;
    };
    std::stable_sort(all.begin(), all.end(), before);
    const auto same = [](const FaceCrossing& a, const FaceCrossing& b) { return a.face == b.face; };
    all.erase(std::unique(all.begin(), all.end(), same), all.end());
  }
}

}  // namespace

Liquid liquid_on(const SparseGrid& grid, const LiquidCells& cells, const Triangles& surface,
                 const Solids& solids, double t) {
  Liquid liquid;
  liquid.grid = &grid;
  liquid.distance.assign(grid.size(), kFar * grid.h());
  std::vector<std::uint8_t> near(grid.size(), 0);
  for (std::size_t b = 0; b < grid.blocks().size(); ++b) {
    const Slot from = cells.grid.find(grid.blocks()[b]);
    if (from == kNoSlot) continue;
    const auto n = static_cast<std::ptrdiff_t>(b * SparseGrid::kCells),
               m = static_cast<std::ptrdiff_t>(from), size = std::ptrdiff_t{SparseGrid::kCells};
    std::copy_n(cells.distance.begin() + m, size, liquid.distance.begin() + n);
    std::copy_n(cells.near.begin() + m, size, near.begin() + n);
  }
  for (const LiquidCells::Run& run : cells.deep)
    for (Index3 c = run.first; c[2] < run.first[2] + run.count; ++c[2])
      if (const Slot s = grid.find(c); s != kNoSlot) liquid.distance[s] = -kFar * grid.h();
  for (int a = 0; a < 3; ++a)
    for (FaceCrossing crossing : cells.crossings[a]) {
      crossing.face = grid.find(cells.grid.cell(crossing.face));
      if (crossing.face != kNoSlot) liquid.crossings[a].push_back(crossing);
    }
  for (auto& along : liquid.crossings)
    std::sort(along.begin(), along.end(),
              [](const FaceCrossing& a, const FaceCrossing& b) { return a.face < b.face; });
  for (const Drop& drop : cells.drops)
    for (const Index3& c : drop.cells)
      if (const Slot s = grid.find(c); s != kNoSlot) liquid.drops.push_back(s);
  sort_unique(liquid.drops);
  if (solids.any()) cross_planes(liquid, continue_into(liquid, near, surface, solids, t));
  return liquid;
}

}  // namespace suture::sims
