#include <catch2/catch.hpp>

#include "kernel/errors.h"
#include "surgery/model/unit.h"
#include "tests/extremes/bodies.h"

using namespace suture;
using namespace suture::surgery;

namespace {

constexpr double kCell = 0.1;                                     // between 2^-4 and 2^-3
constexpr int kDown = kSmallestCell + 4, kUp = kLargestCell + 3;  // the last k on either side

Triangles run(const Triangles& surface, const TrackerOptions& options, bool improve) {
  Tracker tracker(surface, options);
  const SurgeryReport report = tracker.remodel();
  INFO(report.failure);
  CHECK(report.outcome == Outcome::committed);
  if (improve) tracker.improve();
  CHECK(audit(tracker.surface()).closed_manifold());
  return tracker.surface();
}

Triangles run_at(int k, bool improve) {
  return run(times_power(two_balls(), k), {.cell_size = std::ldexp(kCell, k)}, improve);
}

/// The message of an InvalidInput that doing this throws; empty if it throws none.
template <class Do>
std::string refusal(Do what) {
  try {
    what();
  } catch (const InvalidInput& error) {
    return error.what();
  }
  return {};
}

}  // namespace

TEST_CASE("a scene times a power of two gives the same bits times it, to both edges of the range") {
  for (const bool improve : {false, true}) {
    const Triangles twin = run_at(0, improve);
    CHECK(twin.triangles.size() > 1000);
    for (const int k : {kDown, -600, -300, -65, -61, -60, -30, 30, 60, 67, 68, 300, 600, kUp}) {
      CAPTURE(k, improve);
      CHECK(same_bits(run_at(k, improve), times_power(twin, k)));
    }
  }
}

TEST_CASE("one power of two beyond either edge is refused with the range") {
  for (const int k : {kDown - 1, kUp + 1}) {
    const std::string said = refusal([&] { run_at(k, false); });
    CAPTURE(k, said);
    CHECK(said.find("cell_size is " + number(std::ldexp(kCell, k))) != std::string::npos);
    CHECK(said.find("2^-800 to 2^1000") != std::string::npos);
  }
}

TEST_CASE("lengths in a report and distances are scaled as the scene is") {
  for (const int k : {-300, 300}) {
    Tracker tracker(times_power(two_balls(), k), {.cell_size = std::ldexp(kCell, k)});
    Tracker twin(two_balls(), {.cell_size = kCell});
    CHECK(tracker.remodel().volume_after == std::ldexp(twin.remodel().volume_after, 3 * k));
    CHECK(tracker.improve().shortest_edge == std::ldexp(twin.improve().shortest_edge, k));
    const SurfaceDistance d = tracker.distance(), e = twin.distance();
    REQUIRE(d.surface_nodes() == e.surface_nodes());
    for (std::size_t i = 0; i < d.surface_nodes().size(); i += 97)
      CHECK(d.at(d.surface_nodes()[i]) == std::ldexp(e.at(e.surface_nodes()[i]), k));
  }
}

TEST_CASE("a move out of the range is refused and leaves every bit, and time as it was") {
  Tracker tracker(two_balls(), {.cell_size = kCell});
  const Triangles before = tracker.surface();
  std::vector<Point> far = before.positions;
  far[7][1] = 1e30;
  CHECK(refusal([&] { tracker.displace(far, 1); }).find("along y") != std::string::npos);
  const auto drift = [](const Point&, double) { return Point(1e200, 0, 0); };
  CHECK(refusal([&] { tracker.advect(drift, 1e90); }).find("x = 1e+290") != std::string::npos);
  CHECK(refusal([&] { tracker.advect(drift, 1e200); }).find("not finite") != std::string::npos);
  CHECK(same_bits(tracker.surface(), before));
  CHECK(tracker.time() == 0);
}

TEST_CASE("a coordinate that would vanish beside large cells is refused, and zero is not") {
  const int k = 500;
  Triangles surface = times_power(two_balls(), k);
  surface.positions[3][2] = 0;
  Tracker tracker(surface, {.cell_size = std::ldexp(kCell, k)});
  surface.positions[3][2] = 1e-300;
  for (const auto& refused : {refusal([&] { tracker.displace(surface.positions); }), refusal([&] {
                                Tracker(surface, {.cell_size = std::ldexp(kCell, k)});
                              })}) {
    CAPTURE(refused);
    CHECK(refused.find("vertex 3 has z = 1e-300") != std::string::npos);
    CHECK(refused.find("set it to 0") != std::string::npos);
  }
}

TEST_CASE("an origin or an edge length that the unit cannot hold is refused") {
  TrackerOptions options{.cell_size = 0x1p500, .origin = Point(0, 1e-300, 0)};
  const Triangles surface = times_power(two_balls(), 503);
  CHECK(refusal([&] { Tracker(surface, options); }).find("origin has y = 1e-300") !=
        std::string::npos);
  options.origin = Point::Zero();
  options.quality.edge_length = 1e-300;
  CHECK(refusal([&] { Tracker(surface, options); }).find("edge_length is 1e-300") !=
        std::string::npos);
}

TEST_CASE("far from the origin surgery goes on until cells are below the spacing of doubles") {
  const double near = volume(run(two_balls(), {.cell_size = kCell}, false));
  for (const double offset : {1e3, 1e8, 1e11, 1e13}) {
    const Triangles far = translated(two_balls(), offset * Point(1, 0.7, -0.9));
    CAPTURE(offset);
    // Rounding moves a vertex by up to 2^-53 of the offset, and may settle a tie the other way.
    CHECK(volume(run(far, {.cell_size = kCell}, false)) ==
          Approx(near).epsilon(1e-5 + offset * 1e-16));
    run(far, {.cell_size = kCell}, true);
  }
  for (const double offset : {1e15, 1e17, 1e100, 1e300}) {
    const Triangles far = translated(two_balls(), offset * Point(1, 0.7, -0.9));
    const std::string said = refusal([&] { Tracker(far, {.cell_size = kCell}); });
    CAPTURE(said);
    CHECK(said.find("below the spacing of doubles near x") != std::string::npos);
    CHECK(said.find("move the mesh to the origin") != std::string::npos);
  }
}

TEST_CASE("subnormal coordinates and those with a minus before zero change no topology") {
  for (const double tiny : {0x1p-1022, 5e-324, -5e-324, -0.0}) {
    Triangles surface = two_balls(), zeros = surface;
    for (std::size_t v = 0; v < surface.positions.size(); ++v)
      for (int a = 0; a < 3; ++a)
        if (std::abs(surface.positions[v][a]) < 0.05) {
          surface.positions[v][a] = v % 2 == 0 ? tiny : -tiny;
          zeros.positions[v][a] = 0;
        }
    CAPTURE(tiny);
    const Triangles a = run(surface, {.cell_size = kCell}, true);
    const Triangles b = run(zeros, {.cell_size = kCell}, true);
    CHECK(volume(a) == Approx(volume(b)).epsilon(1e-3));
    CHECK(euler_characteristic(a) == euler_characteristic(b));
    if (tiny == 0) CHECK(a.triangles == b.triangles);
  }
}
