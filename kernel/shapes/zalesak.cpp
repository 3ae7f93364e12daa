// Zalesak's slotted sphere: every crease is a row of edges of the mesh.
#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numbers>
#include <span>

#include "kernel/shapes/checks.h"
#include "kernel/shapes/relax.h"
#include "kernel/shapes/rings.h"
#include "kernel/shapes/shapes.h"
#include "kernel/shapes/transform.h"

namespace suture {

namespace {

constexpr double kPi = std::numbers::pi;
const double kRow = std::sqrt(0.75);

// The sphere is turned about x: rows are at constant x, and angles run from +y to +z. Between the
// walls a row ends on the floor. Each face of the surface is a patch of its own, whose border is
// the creases; patches share the vertices there.
class SlottedSphere {
 public:
  explicit SlottedSphere(const ZalesakParameters& p)
      : r_(p.radius), half_(p.slot_width / 2), top_(p.slot_top), h_(p.edge_length) {
    make_columns();
    add_outer_sphere();
    add_floor();
    add_wall(lower_left_, floor_left_, -half_);
    add_wall(lower_right_, floor_right_, half_);
  }
  Triangles take() { return std::move(s_); }

 private:
  static int parts(double length, double edge, int least) {
    return std::max(least, static_cast<int>(std::round(length / edge)));
  }
  double circle(double x) const { return std::sqrt(r_ * r_ - x * x); }
  double floor_angle(double x) const { return std::acos(top_ / circle(x)); }

  std::uint32_t add(const Point& p) {
    s_.positions.push_back(p);
    return static_cast<std::uint32_t>(s_.positions.size() - 1);
  }
  std::uint32_t add_on_circle(double x, double angle) {
    return add({x, circle(x) * std::cos(angle), circle(x) * std::sin(angle)});
  }

  // Rows of the sphere over the slot, from one wall to the other. Their ends lie on the floor.
  void make_columns() {
    const int count = parts(2 * half_, kRow * h_, 1);
    for (int k = 0; k <= count; ++k) {
      const double x = k == count ? half_ : half_ * (2.0 * k / count - 1);
      const double angle = floor_angle(x), z = std::sqrt(circle(x) * circle(x) - top_ * top_);
      const int n = 2 * parts(angle * circle(x), h_, 1) + k % 2;
      Row& row = columns_.emplace_back();
      row.add(add({x, top_, -z}), -angle);
      for (int i = 1; i < n; ++i) {
        const double a = angle * (2.0 * i / n - 1);
        row.add(add_on_circle(x, a), a);
      }
      row.add(add({x, top_, z}), angle);
    }
  }

  // The crease of a wall below the floor, from the end of its column round to its start.
  Row lower_arc(double x, const Row& column) {
    const double start = floor_angle(x), length = 2 * (kPi - start);
    const int n = parts(length * circle(x), h_, 2);
    Row row;
    row.add(column.vertices.back(), start);
    for (int i = 1; i < n; ++i)
      row.add(add_on_circle(x, start + length * i / n), start + length * i / n);
    row.add(column.vertices.front(), start + length);
    return row;
  }

  static Row joined(const Row& first, const Row& second) {
    Row row = first;
    for (std::size_t i = 1; i < second.vertices.size(); ++i)
      row.add(second.vertices[i], second.at[i]);
    return row;
  }

  // The full rows between a wall and the pole beyond it, the pole first.
  std::vector<Row> cap_rows(double side) {
    const double opening = std::acos(half_ / r_), start = -floor_angle(half_);
    const int count = parts(opening * r_, kRow * h_, 2);
    std::vector<Row> rows(1);
    rows[0].add(add({side * r_, 0, 0}), start);
    for (int k = 1; k < count; ++k) {
      const double x = side * r_ * std::cos(opening * k / count);
      const int n = edges_round(circle(x), h_);
      Row& row = rows.emplace_back();
      for (int i = 0; i < n; ++i) {
        const double a = start + 2 * kPi * (i + 0.5 * (k % 2)) / n;
        row.add(add_on_circle(x, a), a);
      }
      row.add(row.vertices.front(), row.at.front() + 2 * kPi);
    }
    return rows;
  }

  void add_outer_sphere() {
    std::vector<Row> rows = cap_rows(-1);
    lower_left_ = lower_arc(-half_, columns_.front());
    lower_right_ = lower_arc(half_, columns_.back());
    rows.push_back(joined(columns_.front(), lower_left_));
    std::vector<Triangle> patch;
    zip_all(rows, patch);
    zip_all(columns_, patch);
    rows = cap_rows(1);
    rows.push_back(joined(columns_.back(), lower_right_));
    std::reverse(rows.begin(), rows.end());
    zip_all(rows, patch);
    finish(
        patch, [r = r_](const Point& p) -> Point { return r * p.normalized(); },
        [this](const Point& a, const Point& b, const Point& c) {
          return a.dot(b.cross(c)) > 0 && spares_slot(a, b, c);
        });
  }

  // A chord of the sphere may dip under the floor or through a wall unless its ends are on the same
  // side of both walls and, between them, not under the floor.
  bool spares_slot(const Point& a, const Point& b, const Point& c) const {
    const double low = std::min({a[0], b[0], c[0]}), high = std::max({a[0], b[0], c[0]});
    if (high <= -half_ || low >= half_) return true;
    return low >= -half_ && high <= half_ && std::min({a[1], b[1], c[1]}) >= top_;
  }

  static void zip_all(std::span<const Row> rows, std::vector<Triangle>& patch) {
    for (std::size_t k = 0; k + 1 < rows.size(); ++k) zip(rows[k], rows[k + 1], patch);
  }

  void add_floor() {
    std::vector<Row> rows;
    for (std::size_t k = columns_.size(); k-- > 0;) {
      const Row& column = columns_[k];
      const Point start = s_.positions[column.vertices.front()];
      const double x = start[0], z = -start[2];
      const int n = 2 * parts(z, h_, 1) + static_cast<int>(k % 2);
      Row& row = rows.emplace_back();
      row.add(column.vertices.front(), -z);
      for (int i = 1; i < n; ++i) {
        const double at = z * (2.0 * i / n - 1);
        row.add(add({x, top_, at}), at);
      }
      row.add(column.vertices.back(), z);
    }
    floor_left_ = rows.back();
    floor_right_ = rows.front();
    std::vector<Triangle> patch;
    zip_all(rows, patch);
    finish_flat(patch, 1, top_, -1);
  }

  // A wall is a segment of a disc: rings shrink from its border to its middle.
  void add_wall(const Row& lower, const Row& chord, double x) {
    Row border = joined(lower, chord);
    const Point middle{x, (top_ - circle(half_)) / 2, 0};
    measure(border);
    const double inner = (top_ + circle(half_)) / 2;
    const int count = parts(inner, kRow * h_, 1);
    std::vector<Row> rows{border};
    for (int k = count - 1; k > 0; --k)
      rows.push_back(shrunk(border, middle, static_cast<double>(k) / count));
    rows.emplace_back().add(add(middle), 0);
    std::vector<Triangle> patch;
    zip_all(rows, patch);
    if (x > 0)
      for (Triangle& t : patch) std::swap(t[1], t[2]);
    finish_flat(patch, 0, x, x < 0 ? 1 : -1);
  }

  // Parameters of a row by length along it.
  void measure(Row& row) const {
    row.at[0] = 0;
    for (std::size_t i = 1; i < row.at.size(); ++i)
      row.at[i] = row.at[i - 1] +
                  (s_.positions[row.vertices[i]] - s_.positions[row.vertices[i - 1]]).norm();
  }

  Row shrunk(const Row& border, const Point& middle, double factor) {
    const double length = border.at.back();
    const int n = parts(length * factor, h_, 6);
    Row row;
    std::size_t side = 0;
    for (int i = 0; i < n; ++i) {
      const double at = length * (i + 0.5) / n;
      while (border.at[side + 1] < at) ++side;
      const double part = (at - border.at[side]) / (border.at[side + 1] - border.at[side]);
      const Point &a = s_.positions[border.vertices[side]],
                  &b = s_.positions[border.vertices[side + 1]];
      row.add(add(middle + factor * (a + part * (b - a) - middle)), at);
    }
    row.add(row.vertices.front(), row.at.front() + length);
    return row;
  }

  void finish_flat(std::vector<Triangle>& patch, int axis, double level, double sign) {
    finish(
        patch,
        [=](const Point& p) -> Point {
          Point q = p;
          q[axis] = level;
          return q;
        },
        [=](const Point& a, const Point& b, const Point& c) {
          return sign * (b - a).cross(c - a)[axis] > 0;
        });
  }

  void finish(std::vector<Triangle>& patch, std::function<Point(const Point&)> project,
              std::function<bool(const Point&, const Point&, const Point&)> admissible) {
    relax(s_.positions, patch, {0, 10, std::move(project), std::move(admissible)});
    s_.triangles.insert(s_.triangles.end(), patch.begin(), patch.end());
  }

  double r_, half_, top_, h_;
  Triangles s_;
  std::vector<Row> columns_;
  Row lower_left_, lower_right_, floor_left_, floor_right_;
};

}  // namespace

Triangles zalesak(const ZalesakParameters& p) {
  require_positive("zalesak: radius", p.radius);
  require_range("zalesak: slot_width", p.slot_width,
                {0.01 * p.radius, p.radius, "0.01 to 1 of the radius"});
  require_range(
      "zalesak: slot_top", p.slot_top,
      {-0.8 * p.radius, 0.8 * p.radius, "within 0.8 of the radius from the centre's height"});
  require_resolution("zalesak", 8 * kPi * p.radius * p.radius, p.edge_length);
  return translated(SlottedSphere(p).take(), p.centre);
}

}  // namespace suture
