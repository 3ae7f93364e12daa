// Loops of arcs, one disc each: the case table of marching cubes is not needed [§6.1 step 5].
#include "surgery/operate/fill.h"

#include <algorithm>

#include "kernel/errors.h"
#include "surgery/operate/triangulate.h"

namespace suture::surgery {

namespace {

/// A loop of sites with, for each, the bits of the cell's faces that it lies on.
struct Loop {
  std::vector<std::uint32_t> sites;
  std::vector<int> faces;
};

/// Takes the arcs of one cell apart into loops. \pre arcs sorted by `from`
std::vector<Loop> link(const Arc* begin, const Arc* end) {
  std::vector<Loop> loops;
  std::vector<char> used(static_cast<std::size_t>(end - begin), 0);
  for (const Arc* first = begin; first != end; ++first) {
    if (used[first - begin] != 0) continue;
    Loop loop;
    const Arc* at = first;
    do {
      used[at - begin] = 1;
      const Arc* next = std::lower_bound(
          begin, end, at->to, [](const Arc& a, std::uint32_t from) { return a.from < from; });
      if (next == end || next->from != at->to || (next != first && used[next - begin] != 0) ||
          (next + 1 != end && next[1].from == next->from))
        throw InternalFailure("fill", "the arcs round a cell do not close to loops");
      loop.sites.push_back(next->from);
      loop.faces.push_back(1 << at->face | 1 << next->face);
      at = next;
    } while (at != first);
    if (loop.sites.size() < 3)
      throw InternalFailure("fill", "a loop has fewer than three vertices");
    loops.push_back(std::move(loop));
  }
  return loops;
}

void fan(const Loop& loop, const std::vector<Point>& positions, Sites& sites, Patch& patch) {
  Point middle = Point::Zero();
  for (const Point& p : positions) middle += p / static_cast<double>(positions.size());
  const std::uint32_t centre = sites.centroid(middle);
  ++patch.centroids;
  for (std::size_t i = 0; i < loop.sites.size(); ++i)
    patch.triangles.push_back({centre, loop.sites[i], loop.sites[(i + 1) % loop.sites.size()]});
}

void fill_loop(const Loop& loop, Sites& sites, Patch& patch) {
  ++patch.loops;
  std::vector<Point> positions;
  for (const std::uint32_t s : loop.sites) positions.push_back(sites[s].position);
  std::optional<std::vector<Triangle>> triangles;
  if (loop.sites.size() <= kMostDynamicCorners)
    triangles = least_area(positions, [&](std::uint32_t i, std::uint32_t j) {
      return (loop.faces[i] & loop.faces[j]) != 0;
    });
  if (!triangles) return fan(loop, positions, sites, patch);
  for (const Triangle& t : *triangles)
    patch.triangles.push_back({loop.sites[t[0]], loop.sites[t[1]], loop.sites[t[2]]});
}

}  // namespace

Patch fill(const std::vector<Arc>& arcs, Sites& sites) {
  std::vector<Arc> sorted = arcs;
  std::sort(sorted.begin(), sorted.end(), [](const Arc& a, const Arc& b) {
    return a.cell != b.cell ? a.cell < b.cell : a.from < b.from;
  });
  Patch patch;
  for (std::size_t begin = 0, end = 0; begin < sorted.size(); begin = end) {
    while (end < sorted.size() && sorted[end].cell == sorted[begin].cell) ++end;
    for (const Loop& loop : link(sorted.data() + begin, sorted.data() + end))
      fill_loop(loop, sites, patch);
  }
  return patch;
}

}  // namespace suture::surgery
