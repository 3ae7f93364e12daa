// The zero surface of a smooth function by marching tetrahedra: closed, manifold, embedded.
#include "kernel/isosurface/isosurface.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "kernel/errors.h"
#include "kernel/isosurface/marching_tetrahedra.h"

namespace suture {

namespace {

class DenseGrid {
 public:
  DenseGrid(const ScalarField& field, const Box& box, double cell)
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
  }

  Triangles surface() const {
    MarchingTetrahedra marching([this](const CubeCorner& from, const CubeCorner& to) {
      return zero_between(place(from.node), place(to.node), from.value < 0);
    });
    for (int k = 0; k + 1 < n_[2]; ++k)
      for (int j = 0; j + 1 < n_[1]; ++j)
        for (int i = 0; i + 1 < n_[0]; ++i) marching.add_cube(cube({i, j, k}));
    return marching.take();
  }

 private:
  std::uint64_t node(const Index3& i) const {
    return (static_cast<std::uint64_t>(i[2]) * n_[1] + i[1]) * n_[0] + i[0];
  }
  std::array<CubeCorner, 8> cube(const Index3& lowest) const {
    std::array<CubeCorner, 8> corners;
    for (int c = 0; c < 8; ++c) {
      const Index3 i = cube_corner(lowest, c);
      corners[c] = {i, node(i), values_[node(i)]};
    }
    return corners;
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

  // Bisection keeps the zero bracketed. It stays off the ends, where vertices of other edges are.
  Point zero_between(const Point& p, const Point& q, bool starts_inside) const {
    constexpr int kHalvings = 30;
    constexpr double kOffEnds = 1e-3;  // of the edge
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
};

}  // namespace

Triangles isosurface(const ScalarField& field, const Box& box, double cell) {
  return DenseGrid(field, box, cell).surface();
}

}  // namespace suture
