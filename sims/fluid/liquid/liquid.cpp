// Which cells of the physics grid are liquid, also continued into the solids that it touches.
#include "sims/fluid/liquid/liquid.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <optional>
#include <utility>

#include "kernel/lists.h"
#include "kernel/measure/nearest_triangle.h"

namespace suture::sims {
namespace {

/// A triangle so near a wall, in cells, is none whose plane the surface has: it lies along the
/// wall, or is one of those that round off the edge where the surface meets it.
constexpr double kTouching = 0.25;

/// A little further from it, one that faces the wall within 60° lies along it.
constexpr double kFacing = -0.5;

/// The normal of a wall is taken over this part of a cell.
constexpr double kNormalStep = 0.01;

using Plane = Eigen::Hyperplane<double, 3>;

/// The triangles near solids that do not lie along them: the surface that has a pressure.
class FreeSurface {
 public:
  FreeSurface(const Triangles& surface, const SolidsAt& solids, double h) : solids_(solids), h_(h) {
    const double reach = (2 * kNear + 1) * h;
    for (const Triangle& triangle : surface.triangles) {
      const std::array<Point, 3> corner{surface.positions[triangle[0]],
                                        surface.positions[triangle[1]],
                                        surface.positions[triangle[2]]};
      const Point middle = (corner[0] + corner[1] + corner[2]) / 3;
      const double d = solids.distance(middle);
      if (d > reach || d <= kTouching * h) continue;
      const Point across = (corner[1] - corner[0]).cross(corner[2] - corner[0]);
      if (across.stableNorm() == 0) continue;
      if (d <= kThinnestAir * h &&
          across.stableNormalized().dot(solids.normal(middle, kNormalStep * h)) < kFacing)
        continue;
      const auto first = static_cast<std::uint32_t>(free_.positions.size());
      free_.triangles.push_back({first, first + 1, first + 2});
      free_.positions.insert(free_.positions.end(), corner.begin(), corner.end());
    }
    if (!free_.triangles.empty()) nearest_ = std::make_unique<NearestTriangle>(free_);
  }

  const SolidsAt& solids() const { return solids_; }

  /// The plane of the nearest triangle, if one is within kNear cells.
  std::optional<Plane> plane(const Point& p) const {
    if (nearest_ == nullptr || nearest_->distance(p) > kNear * h_) return std::nullopt;
    const Triangle& t = free_.triangles[nearest_->triangle(p)];
    const Point& a = free_.positions[t[0]];
    const Point across = (free_.positions[t[1]] - a).cross(free_.positions[t[2]] - a);
    return Plane(across.stableNormalized(), a);
  }

 private:
  SolidsAt solids_;
  double h_;
  Triangles free_;
  std::unique_ptr<NearestTriangle> nearest_;
};

/// A cell whose D was made from a plane: the ways to its neighbours cross that, not what of the
/// surface lies along the solid.
struct Continued {
  Slot slot;
  Plane plane;
};

/// Continues D into solids, and says where; `near`: a slot of the grid each.
std::vector<Continued> continue_into_solids(Liquid& liquid, const std::vector<std::uint8_t>& near,
                                            const FreeSurface& free) {
  const SparseGrid& grid = *liquid.grid;
  const double h = grid.h(), thinnest = kThinnestAir * h;
  std::vector<Continued> continued;
  for (Slot s = 0; s < grid.size(); ++s) {
    if (near[s] == 0) continue;
    const Point p = grid.centre(grid.cell(s));
    const double to_solid = free.solids().distance(p), to_liquid = liquid.distance[s];
    const bool in_solid = to_solid <= 0;
    if (to_liquid < 0 ? !in_solid : to_solid + to_liquid > thinnest) continue;
    if (const std::optional<Plane> plane = free.plane(p)) {
      liquid.distance[s] = plane->signedDistance(p);
      continued.push_back({s, *plane});
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

/// Finds the crossings of the ways from continued cells with their planes. Faces of `axis` that
/// have no crossing yet are returned.
std::vector<FaceCrossing> crossings_of_planes(Liquid& liquid,
                                              const std::vector<Continued>& continued, int axis) {
  const SparseGrid& grid = *liquid.grid;
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
  return added;
}

bool before(const FaceCrossing& a, const FaceCrossing& b) { return a.face < b.face; }

void cross_planes(Liquid& liquid, const std::vector<Continued>& continued) {
  for (int axis = 0; axis < 3; ++axis) {
    const std::vector<FaceCrossing> added = crossings_of_planes(liquid, continued, axis);
    std::vector<FaceCrossing>& all = liquid.crossings[axis];
    all.insert(all.end(), added.begin(), added.end());
    std::stable_sort(all.begin(), all.end(), before);
    const auto same = [](const FaceCrossing& a, const FaceCrossing& b) { return a.face == b.face; };
    all.erase(std::unique(all.begin(), all.end(), same), all.end());
  }
}

/// Takes over the cells' values, block by block.
template <class T>
void copy_blocks(const SparseGrid& from, const std::vector<T>& values, const SparseGrid& to,
                 std::vector<T>& copies) {
  for (std::size_t b = 0; b < to.blocks().size(); ++b) {
    const Slot at = from.find(to.blocks()[b]);
    if (at == kNoSlot) continue;
    std::copy_n(values.begin() + static_cast<std::ptrdiff_t>(at),
                std::ptrdiff_t{SparseGrid::kCells},
                copies.begin() + static_cast<std::ptrdiff_t>(b * SparseGrid::kCells));
  }
}

}  // namespace

double Liquid::way_to_surface(int axis, Slot face) const {
  const Slot below = grid->neighbour(face, axis, -1);
  const auto at = std::lower_bound(crossings[axis].begin(), crossings[axis].end(), face,
                                   [](const FaceCrossing& c, Slot s) { return c.face < s; });
  const bool found = at != crossings[axis].end() && at->face == face;
  if (inside(below))
    return found ? at->highest : distance[below] / (distance[below] - distance[face]);
  return found ? 1 - at->lowest : distance[face] / (distance[face] - distance[below]);
}

std::size_t Liquid::memory() const {
  std::size_t bytes = distance.size() * sizeof(double) + droplet_cells.size() * sizeof(Slot);
  for (const auto& along : crossings) bytes += along.size() * sizeof(FaceCrossing);
  return bytes;
}

Liquid liquid_on(SharedGrid shared, const SampledSurface& sampled) {
  Liquid liquid;
  liquid.grid = std::move(shared);
  const SparseGrid& grid = *liquid.grid;
  liquid.distance.assign(grid.size(), kFar * grid.h());
  copy_blocks(sampled.grid, sampled.distance, grid, liquid.distance);
  for (const SampledSurface::Run& run : sampled.deep)
    for (Index3 c = run.first; c[2] < run.first[2] + run.count; ++c[2])
      if (const Slot s = grid.find(c); s != kNoSlot) liquid.distance[s] = -kFar * grid.h();
  for (int a = 0; a < 3; ++a)
    for (FaceCrossing crossing : sampled.crossings[a]) {
      crossing.face = grid.find(sampled.grid.cell(crossing.face));
      if (crossing.face != kNoSlot) liquid.crossings[a].push_back(crossing);
    }
  for (auto& along : liquid.crossings) std::sort(along.begin(), along.end(), before);
  for (const SubgridDroplet& droplet : sampled.droplets)
    for (const Index3& c : droplet.cells)
      if (const Slot s = grid.find(c); s != kNoSlot) liquid.droplet_cells.push_back(s);
  sort_unique(liquid.droplet_cells);
  return liquid;
}

Liquid liquid_on(SharedGrid grid, const SampledSurface& sampled, const Triangles& surface,
                 const SolidsAt& solids) {
  Liquid liquid = liquid_on(std::move(grid), sampled);
  if (!solids.any()) return liquid;
  std::vector<std::uint8_t> near(liquid.grid->size(), 0);
  copy_blocks(sampled.grid, sampled.near, *liquid.grid, near);
  const FreeSurface free(surface, solids, liquid.grid->h());
  cross_planes(liquid, continue_into_solids(liquid, near, free));
  return liquid;
}

}  // namespace suture::sims
