// The connected parts of the liquid: drops and pools, each with the bubbles that are in it.
#include "sims/fluid/liquid/liquid_bodies.h"

#include <algorithm>
#include <optional>

#include "kernel/measure/measures.h"
#include "kernel/measure/signed_distance.h"

namespace suture::sims {
namespace {

/// A component of the surface, made ready to be asked what is in it when somebody does.
struct Part {
  double volume = 0;
  Point low, high;
  std::uint32_t first = kNone;  ///< triangle
  std::optional<SignedDistance> inside;

  bool holds_box_of(const Part& other) const {
    return (low.array() <= other.low.array()).all() && (high.array() >= other.high.array()).all();
  }
};

/// A part's triangles, each with corners of its own: a winding needs no more.
Triangles triangles_of(const Triangles& surface, const Components& parts, std::uint32_t part) {
  Triangles own;
  for (std::size_t t = 0; t < surface.triangles.size(); ++t) {
    if (parts.of_triangle[t] != part) continue;
    const auto next = static_cast<std::uint32_t>(own.positions.size());
    own.triangles.push_back({next, next + 1, next + 2});
    for (const std::uint32_t v : surface.triangles[t])
      own.positions.push_back(surface.positions[v]);
  }
  return own;
}

/// All components of a surface, which it keeps a reference to.
class Parts {
 public:
  explicit Parts(const Triangles& surface);

  const Components& components() const { return components_; }
  /// The part that `own` is in if it is a cavity, or itself.
  std::uint32_t owner(std::uint32_t own) { return all_[own].volume < 0 ? outer_of(own) : own; }

 private:
  std::uint32_t outer_of(std::uint32_t own);
  bool goes_round(std::uint32_t part, const Point& p) {
    if (!all_[part].inside) all_[part].inside.emplace(triangles_of(surface_, components_, part));
    return all_[part].inside->winding(p) > 0;
  }

  const Triangles& surface_;
  Components components_;
  std::vector<Part> all_;
};

Parts::Parts(const Triangles& surface)
    : surface_(surface), components_(suture::components(surface)), all_(components_.count) {
  const BodyMeasures measures = measure(surface, {components_.of_triangle, components_.count});
  for (std::uint32_t t = 0; t < surface.triangles.size(); ++t) {
    Part& part = all_[components_.of_triangle[t]];
    if (part.first == kNone) {
      part.first = t;
      part.low = part.high = surface.positions[surface.triangles[t][0]];
      part.volume = measures.volume[components_.of_triangle[t]];
    }
    for (const std::uint32_t v : surface.triangles[t]) {
      part.low = part.low.cwiseMin(surface.positions[v]);
      part.high = part.high.cwiseMax(surface.positions[v]);
    }
  }
}

std::uint32_t Parts::outer_of(std::uint32_t own) {
  std::uint32_t by_box = own, by_winding = own;
  const Point& p = surface_.positions[surface_.triangles[all_[own].first][0]];
  const auto smaller = [&](std::uint32_t part, std::uint32_t than) {
    return than == own || all_[part].volume < all_[than].volume;
  };
  for (std::uint32_t part = 0; part < all_.size(); ++part) {
    if (!(all_[part].volume > 0) || !all_[part].holds_box_of(all_[own])) continue;
    if (smaller(part, by_box)) by_box = part;
    if (smaller(part, by_winding) && goes_round(part, p)) by_winding = part;
  }
  return by_winding != own ? by_winding : by_box;
}

}  // namespace

LiquidBodies liquid_bodies(const Triangles& surface) {
  Parts parts(surface);
  std::vector<std::uint32_t> owner(parts.components().count);
  for (std::uint32_t part = 0; part < owner.size(); ++part) owner[part] = parts.owner(part);
  LiquidBodies bodies;
  std::vector<std::uint32_t> number(owner.size(), kNone);
  bodies.of_triangle.reserve(surface.triangles.size());
  for (const std::uint32_t part : parts.components().of_triangle) {
    std::uint32_t& n = number[owner[part]];
    if (n == kNone) n = static_cast<std::uint32_t>(bodies.count++);
    bodies.of_triangle.push_back(n);
  }
  return bodies;
}

BodyMeasures measure(const Triangles& surface, const LiquidBodies& bodies) {
  using Exact = Eigen::Matrix<long double, 3, 1>;
  std::vector<long double> six(bodies.count, 0), twice(bodies.count, 0);
  std::vector<std::uint32_t> centre(bodies.count, kNone);  // a vertex of its own: bodies may be far
  for (std::size_t i = 0; i < surface.triangles.size(); ++i) {
    const Triangle& t = surface.triangles[i];
    const std::uint32_t body = bodies.of_triangle[i];
    if (centre[body] == kNone) centre[body] = t[0];
    const Exact a = surface.positions[t[0]].cast<long double>();
    const Exact normal = (surface.positions[t[1]].cast<long double>() - a)
                             .cross(surface.positions[t[2]].cast<long double>() - a);
    six[body] += (a - surface.positions[centre[body]].cast<long double>()).dot(normal);
    twice[body] += normal.norm();
  }
  BodyMeasures measures;
  for (std::size_t body = 0; body < bodies.count; ++body) {
    measures.volume.push_back(static_cast<double>(six[body] / 6));
    measures.area.push_back(static_cast<double>(twice[body] / 2));
  }
  return measures;
}

std::vector<std::uint32_t> bodies_of_cells(const LiquidBodies& bodies,
                                           const NearestTriangle& nearest, const Liquid& liquid) {
  const SparseGrid& grid = *liquid.grid;
  std::vector<std::uint32_t> body(grid.size(), kNone);
  std::vector<Slot> front;
  for_each_crossing(liquid, [&](int, Slot, Slot cell, const Point& at) {
    if (body[cell] != kNone) return;
    body[cell] = bodies.of_triangle[nearest.triangle(at)];
    front.push_back(cell);
  });
  for (std::size_t next = 0; next < front.size(); ++next)
    for (int axis = 0; axis < 3; ++axis)
      for (const int side : {-1, 1}) {
        const Slot n = grid.neighbour(front[next], axis, side);
        if (n == kNoSlot || !liquid.inside(n) || body[n] != kNone) continue;
        body[n] = body[front[next]];
        front.push_back(n);
      }
  return body;
}

}  // namespace suture::sims
