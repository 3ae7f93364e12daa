// Rows on the lattice: cells from larger than the mesh to 2^62 of them, and surfaces in all of
// them.
#include <fmt/core.h>

#include "tests/bench/extremes/rows.h"
#include "tests/extremes/bodies.h"

namespace suture::extremes {

using namespace suture::surgery;

namespace {

/// Two balls, radius 1, in cells of `size`; the error is that of the union.
Result cells_of(double size, int frequency) {
  Triangles surface = two_balls(frequency);
  Result r = perform(surface, {.cell_size = size});
  const double exact =
      r.outcome == "committed" ? union_of_two_balls(frequency) : volume(two_balls(frequency));
  r.error = relative(volume(surface), exact);
  return r;
}

/// Two pairs of crossing tetrahedra in opposite corners of a lattice of `cells` cells along each
/// axis.
Result far_apart(double cells) {
  const auto pair = [](const Point& at) {
    return together(corner_tetrahedron(at, 6.25),
                    corner_tetrahedron(at + Point(1.25, 1.375, 1.5), 6.25));
  };
  const Point far = Point::Constant(cells - 16);
  Triangles near = pair(Point::Constant(0.125));
  Triangles surface = together(near, translated(near, far));
  perform(near, {.cell_size = 1});
  Result r = perform(surface, {.cell_size = 1});
  if (r.outcome.starts_with("InvalidInput")) return r;
  r.error = relative(volume(surface), 2 * volume(near));
  r.note =
      fmt::format("{} bodies of 4 left; against the near pair alone", components(surface).count);
  return r;
}

Result filled(int cells, const TrackerOptions& options) {
  Triangles surface = gyroid(cells, 0.34);
  const double was = volume(surface);
  Result r = perform(surface, options);
  r.error = relative(volume(surface), was);
  r.note = fmt::format("{} of {} bodies", components(surface).count,
                       components(gyroid(cells, 0.34)).count);
  return r;
}

/// A bar of 12 triangles over n cells, or a plate over n × n.
Result one_over_many(double n, bool plate) {
  const Point size(n, plate ? n : 2.3, 2.3);
  const auto body = [&](const Point& at) { return box({at + size / 2, size, 4 * n}); };
  Triangles surface = together(body({0.1, 0.2, 0.3}), body({0.4, 0.8, 1.4}));
  const double overlap = (size - Point(0.3, 0.6, 1.1)).prod();
  Result r = perform(surface, {.cell_size = 1});
  r.error = relative(volume(surface), 2 * size.prod() - overlap);
  return r;
}

}  // namespace

void add_lattice_rows(std::vector<Row>& rows) {
  for (const double size : {1e200, 1e6, 100.0, 10.0, 4.0, 2.0, 1.0, 0.5, 0.25, 0.1, 0.05, 0.02,
                            0.01, 0.005, 0.0025, 1e-4, 1e-6, 1e-200})
    rows.push_back(
        {"cell size", fmt::format("{:g} radii", size), [=] { return cells_of(size, 64); }});
  for (const int bits : {10, 14, 17, 19, 20})
    rows.push_back({"sparse lattice", fmt::format("2^{} cells", 3 * bits),
                    [=] { return far_apart(std::ldexp(1.0, bits)); }});
  rows.push_back({"sparse lattice", "(2^21 - 3)^3 cells", [] { return far_apart(0x1p21 - 3); }});
  rows.push_back({"sparse lattice", "(2^21 - 2)^3 cells", [] { return far_apart(0x1p21 - 2); }});
  for (const int n : {4, 8, 16, 32}) {
    rows.push_back({"every cell holds mesh", fmt::format("{}^3 cells", n),
                    [=] { return filled(n, {.cell_size = 1}); }});
    rows.push_back({"every cell is re-sampled", fmt::format("{}^3 cells", n), [=] {
                      return filled(n, {.cell_size = 1, .cell_test = CellTest::plain, .depth = 0});
                    }});
  }
  for (const double n : {1e2, 1e3, 1e4, 3e4})
    rows.push_back({"one triangle over many cells", fmt::format("bar, {:g}", n),
                    [=] { return one_over_many(n, false); }});
  for (const double n : {100.0, 300.0, 1000.0})
    rows.push_back({"one triangle over many cells", fmt::format("plate, {:g} x {:g}", n, n),
                    [=] { return one_over_many(n, true); }});
}

}  // namespace suture::extremes
