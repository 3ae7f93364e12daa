// An audit of the whole surface says whether a step is allowed, which is cheap enough for small
// cases.
#include "sims/fuzz/smaller.h"

#include <algorithm>
#include <cmath>

#include "kernel/audit.h"
#include "kernel/lattice.h"
#include "kernel/measure/measures.h"
#include "kernel/shapes/transform.h"

namespace suture::sims {

namespace {

/// The surface without the vertices that no triangle has.
Triangles compacted(const Triangles& surface) {
  Triangles result;
  std::vector<std::uint32_t> now(surface.positions.size(), kNone);
  for (const Triangle& t : surface.triangles) {
    Triangle& fresh = result.triangles.emplace_back(t);
    for (std::uint32_t& v : fresh) {
      if (now[v] == kNone) {
        now[v] = static_cast<std::uint32_t>(result.positions.size());
        result.positions.push_back(surface.positions[v]);
      }
      v = now[v];
    }
  }
  return result;
}

struct Parted {
  Triangles component, others;
};

Parted parted(const Triangles& surface, std::uint32_t k) {
  const Components parts = components(surface);
  Triangles own{surface.positions, {}}, others = own;
  for (std::size_t t = 0; t < surface.triangles.size(); ++t)
    (parts.of_triangle[t] == k ? own : others).triangles.push_back(surface.triangles[t]);
  return {compacted(own), compacted(others)};
}

Triangles inverted(Triangles surface) {
  for (Triangle& t : surface.triangles) std::swap(t[1], t[2]);
  return surface;
}

/// Four of the points, far apart, with a volume above zero unless they lie in a plane.
Triangles tetrahedron_of(const std::vector<Point>& points) {
  std::vector<Point> four{points.front()};
  while (four.size() < 4)
    four.push_back(
        *std::max_element(points.begin(), points.end(), [&](const Point& a, const Point& b) {
          const auto nearest = [&](const Point& p) {
            double d = (p - four[0]).norm();
            for (const Point& q : four) d = std::min(d, (p - q).norm());
            return d;
          };
          return nearest(a) < nearest(b);
        }));
  Triangles result{four, {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}}};
  return volume(result) > 0 ? result : inverted(std::move(result));
}

Triangles box_of(const std::vector<Point>& points) {
  const Box box = bounding_box(points);
  Triangles result;
  for (int c = 0; c < 8; ++c)
    result.positions.emplace_back((c & 1 ? box.high : box.low)[0], (c & 2 ? box.high : box.low)[1],
                                  (c & 4 ? box.high : box.low)[2]);
  result.triangles = {{0, 2, 1}, {1, 2, 3}, {4, 5, 6}, {5, 7, 6}, {0, 1, 4}, {1, 5, 4},
                      {2, 6, 3}, {3, 6, 7}, {0, 4, 2}, {2, 4, 6}, {1, 3, 5}, {3, 7, 5}};
  return result;
}

}  // namespace

Triangles without_component(const Triangles& surface, std::uint32_t k) {
  return parted(surface, k).others;
}

Triangles component_replaced(const Triangles& surface, std::uint32_t k, Stand stand) {
  const auto [own, others] = parted(surface, k);
  Triangles other = stand == Stand::box ? box_of(own.positions) : tetrahedron_of(own.positions);
  if (other.triangles.size() >= own.triangles.size()) return {};
  if (!(volume(own) >= 0)) other = inverted(std::move(other));
  return merged(std::vector<Triangles>{others, other});
}

bool collapse_edge(Triangles& surface, std::size_t t, std::size_t k) {
  const std::uint32_t gone = surface.triangles[t][k], stays = surface.triangles[t][(k + 1) % 3];
  Triangles result{surface.positions, {}};
  for (Triangle v : surface.triangles) {
    std::replace(v.begin(), v.end(), gone, stays);
    if (v[0] != v[1] && v[1] != v[2] && v[2] != v[0]) result.triangles.push_back(v);
  }
  result = compacted(result);
  if (result.triangles.empty() || !audit(result).closed_manifold()) return false;
  surface = std::move(result);
  return true;
}

double rounded_to_bits(double x, int bits) {
  if (x == 0 || !std::isfinite(x)) return x;
  int exponent = 0;
  const double mantissa = std::frexp(x, &exponent);
  return std::ldexp(std::nearbyint(std::ldexp(mantissa, bits)), exponent - bits);
}

}  // namespace suture::sims
