#include "sims/fluid/effects/stress/strain.h"

#include <Eigen/Geometry>
#include <catch2/catch.hpp>

#include "sims/fluid/effects/viscoelasticity.h"
#include "tests/sims/fluid/blobs.h"

namespace suture {

using namespace suture::sims;
namespace {

const ElasticOptions unit = [] {
  ElasticOptions o;
  o.modulus = 1;
  return o;
}();

/// The part of the elastic energy that is left when a ball and its strain have turned about an axis
/// outside of it, and the mean error of the strain.
std::pair<double, double> turned_once(int n, double angle, double dt) {
  const double h = 1.0 / n;
  const auto at = [&](double turn) {
    const Point c = Eigen::AngleAxisd(turn, Point(1, 2, 2) / 3) * Point(0.3, 0.1, 0);
    return std::make_unique<Blob>(n + 3, h, [c](const Point& p) { return (p - c).norm() - 0.6; });
  };
  const auto field = [&](const Point& p, double turn) -> Eigen::Matrix3d {
    const Eigen::AngleAxisd there(turn, Point(1, 2, 2) / 3);
    const Point x = there.inverse() * p;
    Eigen::Matrix3d t;
    t << std::sin(2 * x[1]), 0.5, x[0], 0.5, std::cos(2 * x[2]), -0.2, x[0], -0.2, -1;
    return there.toRotationMatrix() * t * there.toRotationMatrix().transpose();
  };
  const auto filled = [&](const Blob& blob, double turn) {
    Strain s(blob.grid);
    const VolumeFractions fractions = volume_fractions(blob.liquid);
    StrainRate(fractions, blob.solids, WallSlip::none)
        .for_each([&](const RateStencil&, int c, Slot slot) {
          const Point low = blob.grid->centre(blob.grid->cell(slot)) - Point::Constant(h / 2);
          s.known[c < 3 ? 0 : c - 2][slot] = 1;
          if (c < 3) s.elastic.part(c)[slot] = field(low + Point::Constant(h / 2), turn)(c, c);
          if (c >= 3)
            s.elastic.part(c)[slot] =
                field(low + h / 2 * Point::Unit(c - 3), turn)(next_axis(c - 3), prev_axis(c - 3));
        });
    return s;
  };
  auto blob = at(0);
  Strain strain = filled(*blob, 0);
  const double before = elastic_energy(strain, {blob->liquid, {}}, unit);
  const int steps = static_cast<int>(std::lround(angle / dt));
  for (int i = 1; i <= steps; ++i) {
    const MacVelocity u =
        blob->velocity([](const Point& p) -> Point { return (Point(1, 2, 2) / 3).cross(p); });
    auto next = at(angle * i / steps);
    strain = carried(strain, u, next->liquid, angle / steps);
    blob = std::move(next);
  }
  const double after = elastic_energy(strain, {blob->liquid, {}}, unit);
  Strain error = filled(*blob, angle);
  for (int c = 0; c < 6; ++c)
    for (Slot s = 0; s < blob->grid->size(); ++s)
      error.elastic.part(c)[s] -= strain.elastic.part(c)[s];
  return {after / before, std::sqrt(elastic_energy(error, {blob->liquid, {}}, unit) / before)};
}

TEST_CASE("a body that turns keeps the size of its strain, which turns with it") {
  const auto [size_6, error_6] = turned_once(6, 2, 0.2);
  const auto [size_12, error_12] = turned_once(12, 2, 0.2);
  CAPTURE(size_6, error_6, size_12, error_12);
  CHECK(size_12 == Approx(1).margin(0.02));
  CHECK(error_12 < 0.05);
  CHECK(error_12 < 0.5 * error_6);
}

}  // namespace
}  // namespace suture
