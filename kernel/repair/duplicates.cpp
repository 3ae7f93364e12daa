// Repeated triangles are counted in groups, one for each three vertices, so that copies do not
// decide over one another.
#include "kernel/repair/duplicates.h"

#include <algorithm>

#include "kernel/corners.h"
#include "kernel/lists.h"
#include "kernel/union_find.h"

namespace suture {

namespace {

bool same_vertices(const Triangle& a, const Triangle& b) {
  return std::is_permutation(a.begin(), a.end(), b.begin());
}

// Whether two triangles on the same vertices face the same way.
bool same_way(const Triangle& a, const Triangle& b) {
  const auto at = static_cast<std::size_t>(std::find(b.begin(), b.end(), a[0]) - b.begin());
  return b[(at + 1) % 3] == a[1];
}

// The triangles by their three vertices. A group is known by its first triangle.
struct Groups {
  std::vector<std::uint32_t> first;   // of each triangle; kNone if it is unusable
  std::vector<std::uint32_t> copies;  // at the first: how many there are
  std::vector<std::int64_t> net;      // at the first: how many face as it does, less the others

  bool repeated(std::uint32_t group) const { return copies[group] > 1; }
};

Groups groups_of(const Triangles& surface, const Corners& corners) {
  const std::size_t count = surface.triangles.size();
  Groups result{std::vector<std::uint32_t>(count, kNone), std::vector<std::uint32_t>(count, 0),
                std::vector<std::int64_t>(count, 0)};
  for (std::size_t i = 0; i < count; ++i) {
    const Triangle& t = surface.triangles[i];
    if (result.first[i] != kNone || !usable(t, surface.positions.size())) continue;
    corners.for_each_use(t[0], t[1], [&](std::uint32_t other, bool along) {
      if (!same_vertices(t, surface.triangles[other])) return;
      result.first[other] = static_cast<std::uint32_t>(i);
      ++result.copies[i];
      result.net[i] += along ? 1 : -1;
    });
  }
  return result;
}

// The groups at edge k of triangle t, each once.
std::vector<std::uint32_t> groups_at(const Groups& groups, const Corners& corners,
                                     const Triangle& t, std::size_t k) {
  std::vector<std::uint32_t> found;
  corners.for_each_use(t[k], t[(k + 1) % 3],
                       [&](std::uint32_t other, bool) { found.push_back(groups.first[other]); });
  sort_unique(found);
  return found;
}

// For each patch, at its lowest group, the edges and triangles that speak for keeping it, less
// those that speak against. Triangles count where no edge speaks.
struct Votes {
  std::int64_t edges = 0, triangles = 0;
  bool by_edges = false;

  bool keep() const { return (by_edges ? edges : triangles) >= 0; }
};

// For each triangle that is the first of repeated ones whether one of them stays.
std::vector<std::uint8_t> judge(const Triangles& surface, const Groups& groups,
                                const Corners& corners) {
  const std::size_t count = surface.triangles.size();
  UnionFind patches(count);
  std::vector<Votes> own(count), whole(count);
  for (std::uint32_t g = 0; g < count; ++g) {
    if (!groups.repeated(g)) continue;
    own[g].triangles = groups.net[g] != 0 ? 1 : -1;
    for (std::size_t k = 0; k < 3; ++k) {
      const std::vector<std::uint32_t> here = groups_at(groups, corners, surface.triangles[g], k);
      const bool all_repeated = std::all_of(
          here.begin(), here.end(), [&](std::uint32_t other) { return groups.repeated(other); });
      if (!all_repeated) {
        own[g].by_edges = true;
        own[g].edges += here.size() % 2 == 0 ? 1 : -1;
      } else if (here.size() == 2) {
        patches.join(here[0], here[1]);
      }
    }
  }
  for (std::uint32_t g = 0; g < count; ++g) {
    Votes& sum = whole[patches.root(g)];
    sum.edges += own[g].edges;
    sum.triangles += own[g].triangles;
    sum.by_edges |= own[g].by_edges;
  }
  std::vector<std::uint8_t> keep(count, 0);
  for (std::uint32_t g = 0; g < count; ++g) keep[g] = whole[patches.root(g)].keep() ? 1 : 0;
  return keep;
}

}  // namespace

DroppedCopies drop_duplicates(Triangles& surface) {
  const Corners corners(surface);
  const Groups groups = groups_of(surface, corners);
  DroppedCopies dropped;
  if (std::none_of(groups.copies.begin(), groups.copies.end(),
                   [](std::uint32_t copies) { return copies > 1; }))
    return dropped;
  const std::vector<std::uint8_t> keep = judge(surface, groups, corners);
  std::vector<std::uint8_t> gone(keep.size(), 0), found(keep.size(), 0);
  for (std::size_t i = 0; i < keep.size(); ++i) {
    const std::uint32_t g = groups.first[i];
    if (g == kNone || !groups.repeated(g)) continue;
    const bool faces_as_first = same_way(surface.triangles[g], surface.triangles[i]);
    const bool stays =
        keep[g] != 0 && found[g] == 0 && (faces_as_first ? groups.net[g] >= 0 : groups.net[g] < 0);
    if (stays) found[g] = 1;
    gone[i] = stays ? 0 : 1;
    if (!stays) ++(keep[g] != 0 ? dropped.repeated : dropped.cancelled);
  }
  std::size_t kept = 0;
  for (std::size_t i = 0; i < gone.size(); ++i)
    if (gone[i] == 0) surface.triangles[kept++] = surface.triangles[i];
  surface.triangles.resize(kept);
  return dropped;
}

}  // namespace suture
