// The sphere: an icosahedron in equal parts, pushed out.
#include <algorithm>
#include <cmath>
#include <numbers>

#include "kernel/measure/measures.h"
#include "kernel/shapes/checks.h"
#include "kernel/shapes/shapes.h"

namespace suture {

namespace {

using Corners = std::array<int, 3>;

constexpr std::array<Corners, 20> kFaces{
    {{0, 11, 5},  {0, 5, 1},  {0, 1, 7},  {0, 7, 10}, {0, 10, 11}, {1, 5, 9}, {5, 11, 4},
     {11, 10, 2}, {10, 7, 6}, {7, 1, 8},  {3, 9, 4},  {3, 4, 2},   {3, 2, 6}, {3, 6, 8},
     {3, 8, 9},   {4, 9, 5},  {2, 4, 11}, {6, 2, 10}, {8, 6, 7},   {9, 8, 1}}};

Point corner(int c) {
  constexpr double t = std::numbers::phi;
  const double a = c % 2 == 0 ? -1 : 1, b = c % 4 < 2 ? 1 : -1;
  if (c < 4) return {a, b * t, 0};
  if (c < 8) return {0, a, b * t};
  return {b * t, 0, a};
}

// Vertices in the order corners, edges, faces; one shared by several faces gets the same index and
// the same bits from each.
class Geodesic {
 public:
  Geodesic(int frequency, double radius) : n_(frequency), radius_(radius) {
    surface_.positions.resize(10 * static_cast<std::size_t>(n_) * n_ + 2);
    surface_.triangles.reserve(20 * static_cast<std::size_t>(n_) * n_);
    number_edges();
    for (int f = 0; f < 20; ++f)
      for (int i = 0; i < n_; ++i)
        for (int j = 0; i + j < n_; ++j) {
          surface_.triangles.push_back({vertex(f, i, j), vertex(f, i + 1, j), vertex(f, i, j + 1)});
          if (i + j + 1 < n_)
            surface_.triangles.push_back(
                {vertex(f, i + 1, j), vertex(f, i + 1, j + 1), vertex(f, i, j + 1)});
        }
  }
  Triangles take() { return std::move(surface_); }

 private:
  void number_edges() {
    int count = 0;
    for (const Corners& f : kFaces)
      for (int k = 0; k < 3; ++k)
        if (const int a = f[k], b = f[(k + 1) % 3]; a < b) edge_[a][b] = count++;
  }

  std::uint32_t vertex(int face, int i, int j) {
    const Corners& f = kFaces[face];
    std::array<std::pair<int, int>, 3> part{{{n_ - i - j, f[0]}, {i, f[1]}, {j, f[2]}}};
    std::sort(part.begin(), part.end(), [](const auto& a, const auto& b) {
      return (a.first == 0) != (b.first == 0) ? a.first != 0 : a.second < b.second;
    });
    Point p = Point::Zero();
    for (const auto& [parts, c] : part) p += parts * corner(c);
    const std::size_t inner = static_cast<std::size_t>(n_ - 1), edges = 12 + 30 * inner;
    std::size_t at = 0;
    if (part[1].first == 0)
      at = part[0].second;
    else if (part[2].first == 0)
      at = 12 + edge_[part[0].second][part[1].second] * inner + part[1].first - 1;
    else
      at = edges + face * (inner * (inner - 1) / 2) + (i + j - 1) * (i + j - 2) / 2 + j - 1;
    surface_.positions[at] = radius_ * p.normalized();
    return static_cast<std::uint32_t>(at);
  }

  int n_;
  double radius_;
  std::array<std::array<int, 12>, 12> edge_{};
  Triangles surface_;
};

}  // namespace

Triangles sphere(const SphereParameters& p) {
  require_positive("sphere: radius", p.radius);
  const double pi = std::numbers::pi, most = std::floor(std::sqrt(kMostTriangles / 20));
  require_range("sphere: frequency", p.frequency, {0, most, "0 to " + std::to_string(int(most))});
  int frequency = p.frequency;
  if (frequency == 0) {
    const double area = 4 * pi * p.radius * p.radius;
    require_resolution("sphere", area, p.edge_length);
    const double triangles = area / (std::sqrt(0.1875) * p.edge_length * p.edge_length);
    frequency = std::max(1, static_cast<int>(std::round(std::sqrt(triangles / 20))));
  }
  require_range("sphere: exact_volume", p.exact_volume, {0, 1, "0 or 1"});
  Triangles surface = Geodesic(frequency, p.radius).take();
  if (p.exact_volume == 1) {
    const Triangles unit = Geodesic(frequency, 1).take();
    surface = Geodesic(frequency, p.radius * std::cbrt(4 * pi / 3 / volume(unit))).take();
  }
  for (Point& q : surface.positions) q += p.centre;
  return surface;
}

}  // namespace suture
