// The zero surface of a smooth function by marching tetrahedra: closed, manifold, embedded.
#include "kernel/isosurface.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "kernel/errors.h"
#include "kernel/sparse_field.h"

namespace suture {

namespace {

// Corner c of a cube is at (c & 1, c >> 1 & 1, c >> 2). Each tetrahedron goes from corner 0 to 7 in
// three axis steps; swapped where needed so that all are right-handed.
constexpr std::array<std::array<int, 4>, 6> kTetrahedra{
    {{0, 1, 3, 7}, {0, 3, 2, 7}, {0, 2, 6, 7}, {0, 6, 4, 7}, {0, 4, 5, 7}, {0, 5, 1, 7}}};

class MarchingTetrahedra {
 public:
  MarchingTetrahedra(const ScalarField& field, const Box& box, double cell)
      : field_(field), low_(box.low), cell_(cell) {
    double nodes = 1;
    for (int a = 0; a < 3; ++a) {
      const double count = std::ceil((box.high[a] - box.low[a]) / cell) + 1;
      nodes *= count;
      if (!(nodes < 2147483648.0))
        throw InvalidInput("an isosurface's grid of side " + std::to_string(cell) +
                           " has too many nodes; choose a larger side");
      n_[a] = static_cast<int>(count);
    }
    sample();
    for (int k = 0; k + 1 < n_[2]; ++k)
      for (int j = 0; j + 1 < n_[1]; ++j)
        for (int i = 0; i + 1 < n_[0]; ++i) add_cube({i, j, k});
  }
  Triangles take() { return std::move(surface_); }

 private:
  std::uint64_t node(const Index3& i) const {
    return (static_cast<std::uint64_t>(i[2]) * n_[1] + i[1]) * n_[0] + i[0];
  }
  static Index3 corner(const Index3& cube, int c) {
    return {cube[0] + (c & 1), cube[1] + (c >> 1 & 1), cube[2] + (c >> 2)};
  }
  Point place(const Index3& i) const { return low_ + cell_ * Point(i[0], i[1], i[2]); }

  void sample() {
    values_.reserve(static_cast<std::size_t>(n_[0]) * n_[1] * n_[2]);
    for (int k = 0; k < n_[2]; ++k)
      for (int j = 0; j < n_[1]; ++j)
        for (int i = 0; i < n_[0]; ++i) {
          const double value = field_(place({i, j, k}));
          const bool border =
              i == 0 || j == 0 || k == 0 || i + 1 == n_[0] || j + 1 == n_[1] || k + 1 == n_[2];
          if (border && !(value > 0))
            throw InvalidInput("an isosurface reaches the border of its box; choose a larger box");
          values_.push_back(value);
        }
  }

  void add_cube(const Index3& cube) {
    int inside = 0;
    for (int c = 0; c < 8; ++c) inside += values_[node(corner(cube, c))] < 0;
    if (inside == 0 || inside == 8) return;
    for (const auto& t : kTetrahedra) add_tetrahedron(cube, t);
  }

  // Corners are put in an even permutation that brings those inside to the front.
  void add_tetrahedron(const Index3& cube, std::array<int, 4> t) {
    std::array<int, 4> in{};
    for (int k = 0; k < 4; ++k) in[k] = values_[node(corner(cube, t[k]))] < 0;
    const int count = in[0] + in[1] + in[2] + in[3];
    if (count == 0 || count == 4) return;
    int swaps = 0;
    for (int k = 0, front = 0; k < 4; ++k)
      if (in[k]) {
        if (k != front) {
          std::swap(t[k], t[front]);
          std::swap(in[k], in[front]);
          ++swaps;
        }
        ++front;
      }
    if (swaps % 2 == 1) count == 1 ? std::swap(t[2], t[3]) : std::swap(t[0], t[1]);
    const auto v = [&](int a, int b) { return vertex(cube, t[a], t[b]); };
    if (count == 1) {
      surface_.triangles.push_back({v(0, 1), v(0, 2), v(0, 3)});
    } else if (count == 3) {
      surface_.triangles.push_back({v(3, 0), v(3, 1), v(3, 2)});
    } else {
      surface_.triangles.push_back({v(0, 2), v(0, 3), v(1, 3)});
      surface_.triangles.push_back({v(0, 2), v(1, 3), v(1, 2)});
    }
  }

  std::uint32_t vertex(const Index3& cube, int a, int b) {
    if (a > b) std::swap(a, b);  // then b − a, as bits, is the edge's direction
    const Index3 from = corner(cube, a), to = corner(cube, b);
    const std::size_t known = at_.size(), at = at_.index(8 * node(from) + (b - a));
    if (at == known) surface_.positions.push_back(zero_between(from, to));
    return static_cast<std::uint32_t>(at);
  }

  // Bisection keeps the zero bracketed. It stays off the ends, where vertices of other edges are.
  Point zero_between(const Index3& from, const Index3& to) const {
    constexpr int kHalvings = 30;
    constexpr double kOffEnds = 1e-3;  // of the edge
    const Point p = place(from), q = place(to);
    const bool starts_inside = values_[node(from)] < 0;
    double low = 0, high = 1;
    for (int k = 0; k < kHalvings; ++k) {
      const double middle = (low + high) / 2;
      ((field_(p + middle * (q - p)) < 0) == starts_inside ? low : high) = middle;
    }
    return p + std::clamp(low, kOffEnds, 1 - kOffEnds) * (q - p);
  }

  const ScalarField& field_;
  Point low_;
  double cell_;
  Index3 n_{};
  std::vector<double> values_;
  SparseField<char> at_;
  Triangles surface_;
};

}  // namespace

Triangles isosurface(const ScalarField& field, const Box& box, double cell) {
  return MarchingTetrahedra(field, box, cell).take();
}

}  // namespace suture
