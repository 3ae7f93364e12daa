// Rows on shape: aspect ratios, no volume, all vertices in one plane or on the lattice's nodes.
#include <fmt/core.h>

#include "tests/bench/extremes/rows.h"
#include "tests/extremes/bodies.h"

namespace suture::extremes {

using namespace suture::surgery;

namespace {

/// Two balls with slivers of this aspect, against the same two with a gap of 2^-10.
Result slivers(double aspect, const Task& task) {
  Triangles surface = with_slivers(two_balls(24), 1 / aspect);
  Triangles twin = with_slivers(two_balls(24), 1e-3);
  perform(twin, {.cell_size = 0.1}, task);
  Result r = perform(surface, {.cell_size = 0.1}, task);
  r.error = relative(volume(surface), volume(twin));
  r.note = "against the same two bodies with slivers of aspect 10^3";
  return r;
}

/// Two bodies flattened along z, or drawn out along x, and the volume of their union.
Result flattened(const Point& by, const Task& task) {
  Triangles surface = scaled(two_balls(24), by);
  const double exact = union_of_two_balls(24) * by.prod();  // affine maps keep ratios
  Result r = perform(surface, {.cell_size = 0.1}, task);
  r.note = fmt::format("{} bodies of 2", components(surface).count);
  r.error = relative(volume(surface), exact);
  return r;
}

Result without_volume(bool two) {
  Triangles surface =
      two ? together(pillow(20, 3), translated(pillow(20, 3), {0.5, 0.4, 0})) : pillow(20, 3);
  Result r = perform(surface, {.cell_size = 0.25}, {.improve = true});
  r.note = fmt::format("volume {:g}", volume(surface));
  return r;
}

/// Random closed surfaces whose vertices are all nodes of the lattice.
Result on_nodes(const Task& task) {
  Triangles surface = two_balls(16);
  for (Point& p : surface.positions)
    for (double& x : p) x = 0.125 * std::round(8 * x);
  const double was = volume(surface);
  Result r = perform(surface, {.cell_size = 0.125}, task);
  r.error = relative(volume(surface), was);
  r.note = "error against the sum of the two bodies, which overlap";
  return r;
}

/// Everything on one line, or in one point.
Result collapsed(int axes) {
  Triangles surface = two_balls(8);
  for (Point& p : surface.positions)
    for (int a = axes; a < 3; ++a) p[a] = 0.3;
  Result r = perform(surface, {.cell_size = 0.1}, {.improve = true});
  r.note = fmt::format("volume {:g}", volume(surface));
  return r;
}

}  // namespace

void add_shape_rows(std::vector<Row>& rows) {
  for (const int k : {3, 6, 9, 12, 15}) {
    const double aspect = std::pow(10.0, k);
    const std::string value = fmt::format("10^{}", k);
    rows.push_back({"slivers", value, [=] { return slivers(aspect, {}); }});
    rows.push_back(
        {"slivers, with improve", value, [=] { return slivers(aspect, {.improve = true}); }});
    rows.push_back({"flat bodies", value, [=] { return flattened({1, 1, 1 / aspect}, {}); }});
    rows.push_back({"flat bodies, with improve", value, [=] {
                      return flattened({1, 1, 1 / aspect}, {.improve = true});
                    }});
    rows.push_back({"needles", value, [=] { return flattened({1, 1 / aspect, 1 / aspect}, {}); }});
    rows.push_back({"needles, with improve", value, [=] {
                      return flattened({1, 1 / aspect, 1 / aspect}, {.improve = true});
                    }});
  }
  rows.push_back({"no volume", "a pillow", [] { return without_volume(false); }});
  rows.push_back({"no volume", "two pillows in one plane", [] { return without_volume(true); }});
  for (const int axes : {2, 1, 0})
    rows.push_back({"no volume",
                    axes == 2   ? "balls in a plane"
                    : axes == 1 ? "balls on a line"
                                : "balls in a point",
                    [=] { return collapsed(axes); }});
  rows.push_back({"vertices on nodes", "all", [] { return on_nodes({}); }});
  rows.push_back(
      {"vertices on nodes, with improve", "all", [] { return on_nodes({.improve = true}); }});
}

}  // namespace suture::extremes
