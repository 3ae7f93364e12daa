#include <catch2/catch.hpp>
#include <cmath>

#include "kernel/audit.h"
#include "kernel/measure/measures.h"
#include "sims/fuzz/extrude.h"

using namespace suture;
using namespace suture::sims;

TEST_CASE("an extruded polygon is a closed manifold, capped or joined to a ring") {
  std::vector<std::vector<Point>> stations;
  for (int s = 0; s < 4; ++s) {
    const Point to(s == 1 || s == 2 ? 3 : 0, 0, s / 2 * 3);
    stations.push_back({to, to + Point(1, 0, 0), to + Point(1, 1, 0), to + Point(0, 1, 0)});
  }
  for (const Ends ends : {Ends::capped, Ends::joined}) {
    const Triangles surface = extrude(stations, ends);
    CHECK(audit(surface).closed_manifold());
    CHECK(surface.triangles.size() == (ends == Ends::joined ? 32 : 24 + 4));
  }
}

TEST_CASE("a straight tube has the volume of its prism") {
  const Triangles surface = tube({Point(0, 0, 0), Point(0, 0, 2), Point(0, 0, 3)}, {0.5, 6});
  CHECK(audit(surface).closed_manifold());
  const double hexagon = 1.5 * std::sqrt(3.0) * 0.25;
  CHECK(volume(surface) == Approx(3 * hexagon));
}

TEST_CASE("a tube that turns back on itself stays finite") {
  const Triangles surface =
      tube({Point(0, 0, 0), Point(0, 0, 1), Point(0, 0, 0), Point(0, 0, 0)}, {0.1, 4});
  CHECK(audit(surface).closed_manifold());
}
