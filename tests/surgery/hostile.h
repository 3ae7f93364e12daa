// Seeded random and hostile inputs for whole surgeries: the same case for the same seed,
// everywhere.
#pragma once

#include <cmath>
#include <cstdint>
#include <vector>

#include "kernel/random.h"
#include "kernel/shapes/shapes.h"
#include "kernel/shapes/transform.h"
#include "surgery/model/options.h"

namespace suture {

struct HostileCase {
  Triangles surface;
  TrackerOptions options;
};

class HostileCases {
 public:
  explicit HostileCases(std::uint64_t seed) : random_(seed) {}

  HostileCase make() {
    const double cell = std::ldexp(1.0, -static_cast<int>(1 + random_.below(3)));
    std::vector<Triangles> bodies;
    const std::uint64_t count = 1 + random_.below(3);
    for (std::uint64_t b = 0; b < count; ++b) bodies.push_back(placed(body(), cell));
    if (random_.below(6) == 0) bodies.push_back(bodies.front());  // all faces coplanar
    HostileCase result{merged(bodies), options(cell)};
    spoil(result.surface, cell);
    return result;
  }

 private:
  Triangles body() {
    switch (random_.below(7)) {
      case 0:
        return sphere({Point::Zero(), 1, 0.1, static_cast<int>(1 + random_.below(5))});
      case 1:
        return box({Point::Zero(), Point(1, 1, 1), random_.uniform(0.2, 2)});
      case 2:
        return torus({Point::Zero(), 0.8, random_.uniform(0.05, 0.6), 0.35});
      case 3:
        return cylinder({Point::Zero(), 0.6, 1.2, random_.uniform(0.3, 1)});
      case 4:
        return sheet({Point::Zero(), 2, 1.2, random_.uniform(0.01, 0.2), random_.uniform(-280, 280),
                      random_.uniform(0.25, 0.6)});
      case 5:
        return dumbbell({Point::Zero(), 0.4, 1.4, random_.uniform(0.01, 0.2), 0.2, 0.2});
      default:
        return sphere({Point::Zero(), random_.uniform(0.05, 0.4), 0.1, 2});
    }
  }

  Triangles placed(Triangles body, double cell) {
    if (random_.below(2) == 0) {  // one draw after another: the order of arguments is not defined
      const Point axis{random_.uniform(-1, 1), random_.uniform(-1, 1), random_.uniform(0.1, 1)};
      body = rotated(std::move(body), axis, random_.uniform(0, 6.28));
    }
    if (random_.below(4) == 0)
      body = scaled(std::move(body),
                    Point{random_.uniform(0.01, 1.5), random_.uniform(0.2, 1.5), 1.0});
    Point by{random_.uniform(-1, 1), random_.uniform(-1, 1), random_.uniform(-1, 1)};
    if (random_.below(3) == 0)
      for (int a = 0; a < 3; ++a) by[a] = cell * std::round(by[a] / cell);
    return translated(std::move(body), by);
  }

  /// Vertices thrown about, snapped onto planes, lines and nodes, or nudged by one bit.
  void spoil(Triangles& surface, double cell) {
    const std::uint64_t how = random_.below(6);
    const double reach = random_.below(3) == 0 ? 1.0 : 0.2;
    for (Point& p : surface.positions)
      for (int a = 0; a < 3; ++a) {
        if (how == 1) p[a] += random_.uniform(-reach, reach);
        if (how == 2 || (how == 3 && random_.below(3) == 0)) p[a] = cell * std::round(p[a] / cell);
        if (how == 4 && random_.below(2) == 0)
          p[a] = std::nextafter(cell * std::round(p[a] / cell), random_.below(2) == 0 ? -9.0 : 9.0);
        if (how == 5) p[a] = cell / 2 * std::round(2 * p[a] / cell);
      }
  }

  TrackerOptions options(double cell) {
    TrackerOptions o;
    o.cell_size = cell;
    if (random_.below(4) == 0) o.origin = Point::Constant(random_.uniform(0, cell));
    constexpr Events kEvents[] = {Events::both, Events::both, Events::both, Events::merge,
                                  Events::split};
    o.events = kEvents[random_.below(5)];
    if (random_.below(4) == 0) o.cell_test = CellTest::plain;
    o.depth = static_cast<int>(random_.below(3));
    if (random_.below(2) == 0) o.collapse = Collapse::keep;
    if (random_.below(2) == 0) o.placement = Placement::crossing;
    return o;
  }

  Random random_;
};

}  // namespace suture
