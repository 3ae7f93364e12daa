// Rows on the size of numbers: powers of two, offsets from the origin, subnormals, signs of zero.
#include <fmt/core.h>

#include "tests/bench/extremes/rows.h"
#include "tests/extremes/bodies.h"

namespace suture::extremes {

using namespace suture::surgery;

namespace {

/// The surface and the cells × 2^k, against the twin at k = 0.
Result scaled_twin(int k, const Task& task) {
  const double cell = 0.1;
  Triangles twin = two_balls(24), surface = times_power(twin, k);
  perform(twin, {.cell_size = cell}, task);
  Result r = perform(surface, {.cell_size = std::ldexp(cell, k)}, task);
  if (r.outcome.starts_with("InvalidInput")) return r;
  r.bits = same_bits(surface, times_power(twin, k)) ? "yes" : "no";
  r.error = relative(volume(times_power(surface, -k)), volume(twin));
  return r;
}

/// Two balls 10^k from the origin, against the same two balls near it, their vertices rounded
/// alike.
Result offset_twin(int k, double cell) {
  const Point by = std::pow(10.0, k) * Point(1, 0.7, -0.9);
  Triangles twin = two_balls(24), surface = translated(twin, by);
  const Result near = perform(twin, {.cell_size = cell});
  Result r = perform(surface, {.cell_size = cell});
  if (r.outcome.starts_with("InvalidInput")) return r;
  r.error = relative(volume(surface), volume(twin));
  return r;
}

/// Two balls of which one vertex in three has a subnormal coordinate.
Result with_subnormals(double tiny) {
  Triangles surface = two_balls(24), twin = surface;
  for (std::size_t v = 0; v < surface.positions.size(); v += 3) {
    const int axis = static_cast<int>(v % 2);
    if (std::abs(surface.positions[v][axis]) > 0.1) continue;
    surface.positions[v][axis] = v % 4 == 0 ? tiny : -tiny;
    twin.positions[v][axis] = 0;
  }
  perform(twin, {.cell_size = 0.1});
  Result r = perform(surface, {.cell_size = 0.1});
  r.error = relative(volume(surface), volume(twin));
  r.note = "against the same mesh with zeros in their place";
  return r;
}

/// A box on the lattice's planes through the origin, with −0 for every 0.
Result negative_zeros() {
  const auto boxes = [] {
    return together(box({Point(1, 1, 1), Point(2, 2, 2), 0.25}),
                    box({Point(2, 1.5, 0), Point(2, 2, 2), 0.25}));
  };
  Triangles twin = boxes(), surface = twin;
  for (Point& p : surface.positions)
    for (double& x : p)
      if (x == 0) x = -0.0;
  perform(twin, {.cell_size = 0.25}, {.improve = true});
  Result r = perform(surface, {.cell_size = 0.25}, {.improve = true});
  for (Triangles* s : {&surface, &twin})
    for (Point& p : s->positions) p += Point::Zero();  // −0 becomes 0
  r.bits = same_bits(surface, twin) ? "yes" : "no";
  r.error = relative(volume(surface), volume(twin));
  return r;
}

}  // namespace

void add_scale_rows(std::vector<Row>& rows) {
  for (const bool improve : {false, true})
    for (const int k : {-1070, -1000, -900, -797, -796, -700, -500, -300, -260, -100, -60,  -1,
                        1,     60,    100,  260,  300,  500,  700,  900,  1000, 1003, 1004, 1020}) {
      rows.push_back({improve ? "scale, with improve" : "scale", fmt::format("2^{}", k),
                      [=] { return scaled_twin(k, {.improve = improve}); }});
    }
  for (const int k : {0, 2, 4, 6, 8, 10, 12, 13, 14, 15, 16, 17, 100, 300})
    rows.push_back({"offset", fmt::format("10^{} radii", k), [=] { return offset_twin(k, 0.1); }});
  for (const double tiny : {0x1p-1022, 0x1p-1040, 5e-324})
    rows.push_back(
        {"subnormal coordinates", text("%.3g", tiny), [=] { return with_subnormals(tiny); }});
  rows.push_back({"negative zero", "boxes on planes", negative_zeros});
}

}  // namespace suture::extremes
