#include <Eigen/Geometry>
#include <catch2/catch.hpp>
#include <cmath>
#include <numbers>

#include "kernel/errors.h"
#include "kernel/random.h"
#include "sims/flows/bodies.h"
#include "sims/flows/fields.h"
#include "sims/flows/mean_curvature.h"
#include "sims/flows/normal_flow.h"
#include "surgery/advect.h"
#include "tests/sims/balls.h"

using namespace suture;
using namespace suture::surgery;
using namespace suture::sims;

namespace {

Point random_point(Random& random, double low, double high) {
  const double x = random.uniform(low, high), y = random.uniform(low, high);
  return {x, y, random.uniform(low, high)};
}

/// Largest divergence over the largest single derivative, by central differences.
double relative_divergence(const VelocityField& u, double low, double high) {
  constexpr double h = 1e-5;
  Random random(7);
  double largest = 0, scale = 0;
  for (int i = 0; i < 200; ++i) {
    const Point x = random_point(random, low, high);
    const double t = random.uniform(0, 1);
    double divergence = 0;
    for (int axis = 0; axis < 3; ++axis) {
      const Point d = h * Point::Unit(axis);
      const Point change = (u(x + d, t) - u(x - d, t)) / (2 * h);
      divergence += change[axis];
      scale = std::max(scale, change.cwiseAbs().maxCoeff());
    }
    largest = std::max(largest, std::abs(divergence));
  }
  return largest / scale;
}

std::vector<Point> random_markers(int count) {
  Random random(11);
  std::vector<Point> markers;
  for (int i = 0; i < count; ++i)
    markers.push_back(Point::Constant(0.35) + 0.15 * random_point(random, -1, 1).normalized());
  return markers;
}

double largest_distance(const std::vector<Point>& a, const std::vector<Point>& b) {
  double largest = 0;
  for (std::size_t i = 0; i < a.size(); ++i) largest = std::max(largest, (a[i] - b[i]).norm());
  return largest;
}

/// One point through a field by so many steps of RK4.
Point carried_by(const VelocityField& u, const Point& start, double from, double to, int steps) {
  std::vector<Point> p = {start};
  const double dt = (to - from) / steps;
  for (int i = 0; i < steps; ++i) p = advected(p, u, from + i * dt, dt);
  return p[0];
}

double mean_radius(const std::vector<Point>& positions) {
  double sum = 0;
  for (const Point& p : positions) sum += p.norm();
  return sum / static_cast<double>(positions.size());
}

TrackerOptions coarse() {
  TrackerOptions options;
  options.cell_size = 0.2;
  return options;
}

}  // namespace

TEST_CASE("every velocity field is free of divergence") {
  // Central differences with a step of 1e-5 leave about 1e-10 to 1e-8 of a derivative.
  CHECK(relative_divergence(rotation({}), -1, 1) < 1e-6);
  CHECK(relative_divergence(enright({}), 0, 1) < 1e-6);
  CHECK(relative_divergence(enright({EnrightVariant::eltopo, 3}), 0, 1) < 1e-6);
  CHECK(relative_divergence(curl_noise({.seed = 3, .wavelength = 0.7, .period = 2}), -1, 1) < 1e-6);
  CHECK(relative_divergence(curl_noise({.seed = 3, .wavelength = 0.7, .radius = 1.5}), -1, 1) <
        1e-6);
  CHECK(relative_divergence(vortex(), 0, 1) < 1e-6);
  CHECK(relative_divergence(reversed(vortex(), 2), 0, 1) < 1e-6);
  CHECK(relative_divergence(stretch({.axis = Point(1, 2, 3)}), -1, 1) < 1e-6);
  CHECK(relative_divergence(stretch({.axis = Point(1, 2, 3), .width = 0.4}), -1, 1) < 1e-6);
  CHECK(relative_divergence(fold({.axis = Point(1, 1, 0), .up = Point(-1, 1, 0)}), -1, 1) < 1e-6);
}

TEST_CASE("Enright's vortex brings markers back after its period in both variants") {
  const std::vector<Point> start = random_markers(200);
  for (const EnrightVariant variant : {EnrightVariant::leveque, EnrightVariant::eltopo}) {
    const VelocityField u = enright({variant, 3});
    std::vector<Point> markers = start;
    double farthest = 0;
    for (int step = 0; step < 300; ++step) {
      markers = advected(markers, u, 0.01 * step, 0.01);
      farthest = std::max(farthest, largest_distance(markers, start));
    }
    CHECK(farthest > 0.3);                           // it did move
    CHECK(largest_distance(markers, start) < 1e-6);  // RK4 at 0.01: 2.3e-8 was seen
  }
}

TEST_CASE("the two variants of Enright's vortex agree where they turn") {
  const std::vector<Point> start = random_markers(50);
  std::vector<Point> a = start, b = start;
  for (int step = 0; step < 300; ++step) {
    a = advected(a, enright({EnrightVariant::leveque, 3}), 0.005 * step, 0.005);
    b = advected(b, enright({EnrightVariant::eltopo, 3}), 0.005 * step, 0.005);
  }
  CHECK(largest_distance(a, b) < 1e-6);  // both integrals over half a period are 3/π
}

TEST_CASE("one revolution of Zalesak's rotation brings every point back") {
  const VelocityField u = rotation({.centre = Point(50, 50, 50), .rate = std::numbers::pi / 314});
  CHECK((u(Point(50, 75, 50), 0) - Point(-25 * std::numbers::pi / 314, 0, 0)).norm() < 1e-14);
  std::vector<Point> start;
  for (const Point& p : random_markers(100)) start.push_back(100 * p);
  std::vector<Point> markers = start;
  for (int step = 0; step < 628; ++step) markers = advected(markers, u, step, 1);
  CHECK(largest_distance(markers, start) < 1e-5);
}

TEST_CASE("any flow is undone at the end of its reversal, and was itself until the middle") {
  const VelocityField there = vortex(), both = reversed(vortex(), 2);
  const Point start(0.5, 0.75, 0.3);
  const double pi = std::numbers::pi;
  const Point middle = carried_by(both, start, 0, 1, 200);
  CHECK((middle - carried_by(there, start, 0, 2 / pi, 200)).norm() < 1e-8);
  CHECK((middle - start).norm() > 0.1);
  CHECK((carried_by(both, start, 0, 2, 400) - start).norm() < 1e-8);
  CHECK_THROWS_AS(reversed(vortex(), 0), InvalidInput);
}

TEST_CASE("curl noise is the same for the same seed and another for another") {
  const Point x(0.3, -0.2, 0.9);
  const CurlNoiseParameters p{.seed = 5, .period = 3};
  CurlNoiseParameters q = p;
  q.seed = 6;
  CHECK(curl_noise(p)(x, 0.4) == curl_noise(p)(x, 0.4));
  CHECK(curl_noise(p)(x, 0.4) != curl_noise(p)(x, 0.8));
  CHECK((curl_noise(p)(x, 0.4) - curl_noise(q)(x, 0.4)).norm() > 1e-3);
}

TEST_CASE("curl noise has the speed it was asked for and stays inside its ball") {
  const VelocityField u = curl_noise({.seed = 9, .wavelength = 0.3, .speed = 2});
  const VelocityField faded = curl_noise({.seed = 9, .radius = 1});
  Random random(13);
  double square = 0;
  for (int i = 0; i < 4000; ++i) {
    const Point x = random_point(random, -10, 10);
    square += u(x, 0).squaredNorm() / 4000;
    CHECK(faded(x.normalized() * 1.0000001, 0) == Point::Zero());
  }
  CHECK(std::sqrt(square) == Approx(2).epsilon(0.1));
}

TEST_CASE("a stretch of finite width moves far ends rigidly and thins the neck") {
  const VelocityField u = stretch({.rate = 2, .width = 0.25});
  CHECK((u(Point(5, 1, 1), 0) - Point(0.5, 0, 0)).norm() < 1e-9);
  CHECK((u(Point(0, 0.1, 0), 0) - Point(0, -0.1, 0)).norm() < 1e-12);
}

TEST_CASE("fields without a direction are refused") {
  CHECK_THROWS_AS(rotation({.axis = Point::Zero()}), InvalidInput);
  CHECK_THROWS_AS(stretch({.axis = Point::Zero()}), InvalidInput);
  CHECK_THROWS_AS(fold({.axis = Point(1, 0, 0), .up = Point(1, 0, 1)}), InvalidInput);
}

TEST_CASE("normal flow makes a sphere's radius grow by speed times time") {
  Triangles ball = subdivided_ball(4, 1);
  for (int step = 0; step < 20; ++step) ball.positions = normal_flow(ball, 0.02);
  // Vertex normals of this mesh are off the radial direction by up to about a degree.
  CHECK(mean_radius(ball.positions) == Approx(1.4).epsilon(1e-3));
}

TEST_CASE("mean curvature flow shrinks a sphere as the exact law says") {
  Triangles ball = subdivided_ball(4, 1);
  constexpr double dt = 0.001;
  for (int step = 0; step < 150; ++step) ball.positions = mean_curvature_flow(ball, dt);
  CHECK(mean_radius(ball.positions) == Approx(std::sqrt(1 - 4 * 0.15)).epsilon(0.01));
}

TEST_CASE("mean curvature flow is stable at a time step far beyond the explicit limit") {
  const Triangles ball = subdivided_ball(4, 1);
  const std::vector<Point> after = mean_curvature_flow(ball, 10);
  for (const Point& p : after) {
    REQUIRE(p.allFinite());
    CHECK(p.norm() < 1);
  }
}

TEST_CASE("mean curvature flow accepts triangles without area") {
  Triangles ball = subdivided_ball(2, 1);
  ball.positions[ball.triangles[0][0]] = ball.positions[ball.triangles[0][1]];
  for (const Point& p : mean_curvature_flow(ball, 0.01)) CHECK(p.allFinite());
}

TEST_CASE("bodies move with their own velocities until they are one") {
  const Triangles one = subdivided_ball(2, 0.5);
  const Triangles two = beside(one, one, Point(3, 0, 0));
  std::vector<Point> velocities(two.positions.size(), Point(-1, 0, 0));
  std::fill_n(velocities.begin(), one.positions.size(), Point(1, 0, 0));
  Tracker tracker(two, coarse());
  const auto motion = make_bodies_motion(velocities, 0.5);
  for (int step = 0; step < 10; ++step) motion->advance(tracker, 0.05);
  CHECK(tracker.time() == Approx(0.5));
  CHECK((tracker.surface().positions.front() - one.positions.front() - Point(0.5, 0, 0)).norm() <
        1e-12);
  CHECK((tracker.surface().positions.back() - two.positions.back() - Point(-0.5, 0, 0)).norm() <
        1e-12);
}

TEST_CASE("what is one component comes to move with its mean velocity") {
  const Triangles ball = subdivided_ball(3, 1);
  std::vector<Point> velocities;
  for (const Point& p : ball.positions)
    velocities.push_back({p[0] > 0 ? -1.0 : p[0] < 0 ? 1.0 : 0.0, 0.5, 0});
  Tracker tracker(ball, coarse());
  const auto motion = make_bodies_motion(velocities, 0.01);
  motion->advance(tracker, 1);
  for (std::size_t v = 0; v < ball.positions.size(); ++v)
    CHECK((tracker.surface().positions[v] - ball.positions[v] - Point(0, 0.5, 0)).norm() < 1e-9);
}
