// Rows are zipped by the middles of their edges; neighbouring circles are staggered.
#include "kernel/shapes/rings.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace suture {

void zip(const Row& lower, const Row& upper, std::vector<Triangle>& triangles) {
  const auto middle = [](const Row& row, std::size_t i) { return (row.at[i] + row.at[i + 1]) / 2; };
  std::size_t i = 0, j = 0;
  const std::size_t m = lower.vertices.size() - 1, n = upper.vertices.size() - 1;
  while (i < m || j < n) {
    if (j == n || (i < m && middle(lower, i) <= middle(upper, j))) {
      triangles.push_back({lower.vertices[i], lower.vertices[i + 1], upper.vertices[j]});
      ++i;
    } else {
      triangles.push_back({lower.vertices[i], upper.vertices[j + 1], upper.vertices[j]});
      ++j;
    }
  }
}

Triangles revolved(std::span<const Circle> circles, Profile profile) {
  Triangles surface;
  std::vector<Row> rows;
  for (std::size_t k = 0; k < circles.size(); ++k) {
    const auto& [radius, height, count] = circles[k];
    const auto first = static_cast<std::uint32_t>(surface.positions.size());
    const std::uint32_t n = radius > 0 ? static_cast<std::uint32_t>(count) : 1;
    const double stagger = k % 2 == 0 ? 0 : 0.5;
    Row& row = rows.emplace_back();
    for (std::uint32_t i = 0; i < n; ++i) {
      const double turn = (i + stagger) / n, angle = 2 * std::numbers::pi * turn;
      surface.positions.push_back({radius * std::cos(angle), radius * std::sin(angle), height});
      row.add(first + i, turn);
    }
    if (radius > 0) row.add(first, 1 + stagger / n);
  }
  for (std::size_t k = 0; k + 1 < rows.size(); ++k) zip(rows[k], rows[k + 1], surface.triangles);
  if (profile == Profile::closed) zip(rows.back(), rows.front(), surface.triangles);
  return surface;
}

int edges_round(double radius, double edge_length, int least) {
  const double count = std::round(2 * std::numbers::pi * radius / edge_length);
  return std::max(least, static_cast<int>(count));
}

std::vector<double> graded_steps(double length, const std::function<double(double)>& step) {
  constexpr int kParts = 2000;  // the integral of 1/step has; its error only shifts the grading
  std::vector<double> sum(kParts + 1, 0.0);
  const double part = length / kParts;
  for (int i = 0; i < kParts; ++i) sum[i + 1] = sum[i] + part / step((i + 0.5) * part);
  const int count = std::max(1, static_cast<int>(std::round(sum.back())));
  std::vector<double> steps{0.0};
  int at = 0;
  for (int k = 1; k < count; ++k) {
    const double wanted = sum.back() * k / count;
    while (sum[at + 1] < wanted) ++at;
    steps.push_back(part * (at + (wanted - sum[at]) / (sum[at + 1] - sum[at])));
  }
  steps.push_back(length);
  return steps;
}

}  // namespace suture
