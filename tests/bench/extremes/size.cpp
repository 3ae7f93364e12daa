// Rows on how many: triangles, bodies, bodies inside bodies, triangles round one vertex.
#include <fmt/core.h>

#include "tests/bench/extremes/rows.h"
#include "tests/extremes/bodies.h"
#include "tests/surgery/exact_union.h"

namespace suture::extremes {

using namespace suture::surgery;

double union_of_two_balls(int frequency) {
  if (frequency <= 64)
    return exact_union_volume(ball(1, {0.013, 0.007, 0.003}, frequency),
                              ball(1, {1.2, 0.3, 0.1}, frequency));
  const double d = Point(1.187, 0.293, 0.097).norm();
  return 8.0 / 3 * std::numbers::pi -
         std::numbers::pi * (2 - d) * (2 - d) * (d * d + 4 * d) / (12 * d);
}

namespace {

Result two_balls_of(int frequency, const Task& task) {
  Triangles surface = two_balls(frequency);
  const double cell = 2.4 / std::max(4, frequency / 2);
  Result r = perform(surface, {.cell_size = cell}, task);
  r.error = relative(volume(surface), union_of_two_balls(frequency));
  r.note = fmt::format("cell {:.4g}", cell);
  return r;
}

Result bodies(const Triangles& start, double cell, double exact) {
  Triangles surface = start;
  Result r = perform(surface, {.cell_size = cell});
  r.error = relative(volume(surface), exact);
  r.note = fmt::format("{} bodies, then {}", components(start).count, components(surface).count);
  return r;
}

Result disjoint(int count) {
  const Triangles grid = ball_grid(count, 0.4);
  return bodies(grid, 0.15, volume(grid));
}

/// Balls in a row, each into the next.
Result chain(int count, int along) {
  const Triangles one = ball(0.7, Point::Zero(), 4);
  std::vector<Triangles> all;
  for (int i = 0; i < count; ++i)
    all.push_back(translated(one, Point(i % along + 0.013, 3 * (i / along) + 0.007, 0.003)));
  const Triangles row = merged(all);
  const double rows = std::ceil(static_cast<double>(count) / along);
  const double two = exact_union_volume(one, translated(one, Point(1, 0, 0)));
  const double exact = volume(one) * count - (2 * volume(one) - two) * (count - rows);
  return bodies(row, 0.15, exact);
}

Result pile(int count) {
  Random random(7);
  const double side = std::cbrt(count) * 0.8;
  std::vector<Triangles> all;
  const Triangles one = ball(0.5, Point::Zero(), 2);
  for (int i = 0; i < count; ++i) {
    const double x = random.uniform(0, side), y = random.uniform(0, side);
    all.push_back(translated(one, Point(x, y, random.uniform(0, side))));
  }
  Triangles surface = merged(all);
  Result r = perform(surface, {.cell_size = 0.15});
  r.note = fmt::format("{} bodies, then {}", count, components(surface).count);
  return r;
}

Result one_inside_another(int count, bool cavities) {
  const Triangles start = nested(count, cavities, 24);
  const double outer = volume(ball(1, Point::Zero(), 24));
  return bodies(start, 0.02, cavities ? volume(start) : outer);
}

Result fan(std::uint32_t n, const Task& task) {
  Triangles cone = double_cone(n);
  Triangles surface = together(cone, translated(cone, {0.21, 0.13, 0.07}));
  Result r = perform(surface, {.cell_size = 0.1}, task);
  r.note = fmt::format("{} bodies", components(surface).count);
  return r;
}

}  // namespace

void add_size_rows(std::vector<Row>& rows) {
  rows.push_back({"triangles", "4", [] {
                    Triangles surface = corner_tetrahedron({0.1, 0.2, 0.3}, 6.3);
                    const double was = volume(surface);
                    Result r = perform(surface, {.cell_size = 1}, {.improve = true});
                    r.error = relative(volume(surface), was);
                    return r;
                  }});
  for (const int frequency : {1, 4, 16, 50, 112, 158, 354})
    rows.push_back({"triangles", fmt::format("{}", 40 * frequency * frequency),
                    [=] { return two_balls_of(frequency, {}); }});
  for (const int frequency : {50, 158, 354})
    rows.push_back({"triangles, with improve", fmt::format("{}", 40 * frequency * frequency),
                    [=] { return two_balls_of(frequency, {.improve = true}); }});
  for (const int count : {10, 100, 1000, 10000}) {
    const std::string value = fmt::format("{}", count);
    rows.push_back({"bodies apart", value, [=] { return disjoint(count); }});
    rows.push_back({"bodies in a chain", value, [=] { return chain(count, count); }});
    rows.push_back(
        {"bodies in 100 chains", value, [=] { return chain(count, (count + 99) / 100); }});
    rows.push_back({"bodies in a pile", value, [=] { return pile(count); }});
  }
  for (const int count : {2, 3, 10, 30}) {
    rows.push_back({"nested", fmt::format("{} deep", count),
                    [=] { return one_inside_another(count, false); }});
    rows.push_back({"nested, with cavities", fmt::format("{} deep", count),
                    [=] { return one_inside_another(count, true); }});
  }
  for (const std::uint32_t n : {100U, 1000U, 10000U, 100000U}) {
    rows.push_back(
        {"triangles round one vertex", fmt::format("{}", n), [=] { return fan(n, {}); }});
    if (n <= 10000)
      rows.push_back({"triangles round one vertex, with improve", fmt::format("{}", n),
                      [=] { return fan(n, {.improve = true}); }});
  }
}

}  // namespace suture::extremes
