// Shapes made of flat grids: the box, and the sheet bent from one.
#include <algorithm>
#include <cmath>
#include <numbers>

#include "kernel/shapes/checks.h"
#include "kernel/shapes/shapes.h"
#include "kernel/shapes/transform.h"
#include "kernel/sparse_field.h"

namespace suture {

namespace {

// Vertices are found again by their grid index; every grid point of the surface is made once.
class GridBox {
 public:
  GridBox(const Point& size, double edge_length) : size_(size) {
    for (std::size_t a = 0; a < 3; ++a)
      cells_[a] = std::max(1, static_cast<int>(std::ceil(size[a] / edge_length - kSlack)));
    for (int axis = 0; axis < 3; ++axis) {
      add_side(axis, 0);
      add_side(axis, cells_[axis]);
    }
  }
  Triangles take() { return std::move(surface_); }

 private:
  static constexpr double kSlack = 1e-9;  // relative: 1/0.1 is ten cells, not eleven

  std::uint32_t vertex(const Index3& i) {
    const std::size_t known = index_.size(), at = index_.index(pack(i));
    if (at == known) {
      Point p;
      for (int a = 0; a < 3; ++a) p[a] = size_[a] * (static_cast<double>(i[a]) / cells_[a] - 0.5);
      surface_.positions.push_back(p);
    }
    return static_cast<std::uint32_t>(at);
  }

  void add_side(int axis, int level) {
    const int u = level == 0 ? prev_axis(axis) : next_axis(axis);
    const int v = level == 0 ? next_axis(axis) : prev_axis(axis);
    for (int i = 0; i < cells_[u]; ++i)
      for (int j = 0; j < cells_[v]; ++j) {
        Index3 corner{};
        corner[axis] = level;
        std::array<std::uint32_t, 4> q{};  // counter-clockwise seen from outside
        for (int k = 0; k < 4; ++k) {
          corner[u] = i + (k == 1 || k == 2);
          corner[v] = j + (k >= 2);
          q[k] = vertex(corner);
        }
        add_square(q, (i + j) % 2);
      }
  }

  void add_square(const std::array<std::uint32_t, 4>& q, int turn) {
    surface_.triangles.push_back({q[turn], q[turn + 1], q[turn + 2]});
    surface_.triangles.push_back({q[turn], q[turn + 2], q[(turn + 3) % 4]});
  }

  Point size_;
  Index3 cells_{};
  SparseField<char> index_;
  Triangles surface_;
};

}  // namespace

Triangles box(const BoxParameters& p) {
  for (int a = 0; a < 3; ++a) require_positive("box: size", p.size[a]);
  const Point& s = p.size;
  require_resolution("box", 2 * (s[0] * s[1] + s[1] * s[2] + s[2] * s[0]), p.edge_length);
  return translated(GridBox(p.size, p.edge_length).take(), p.centre);
}

Triangles sheet(const SheetParameters& p) {
  require_positive("sheet: length", p.length);
  require_positive("sheet: width", p.width);
  require_positive("sheet: thickness", p.thickness);
  require_range("sheet: bend", p.bend, {-300, 300, "between -300 and 300 degrees"});
  const double angle = p.bend * std::numbers::pi / 180, bend_radius = p.length / std::abs(angle);
  if (!(p.thickness < bend_radius))
    throw InvalidInput("sheet: thickness " + number(p.thickness) +
                       " does not fit the bend, whose radius is " + number(bend_radius) +
                       "; choose a thinner sheet or a smaller bend");
  Triangles flat = box({Point::Zero(), {p.length, p.width, p.thickness}, p.edge_length});
  if (angle != 0)
    for (Point& q : flat.positions) {
      const double turn = angle * q[0] / p.length, radius = p.length / angle - q[2];
      const double half = std::sin(turn / 2);  // radius·(1 − cos) without cancellation
      q = {radius * std::sin(turn), q[1], q[2] + radius * 2 * half * half};
    }
  return translated(std::move(flat), p.centre);
}

}  // namespace suture
