// Losses are measured on bodies of which a known part is gone.
#include "kernel/measure/body_loss.h"

#include <algorithm>
#include <catch2/catch.hpp>

#include "kernel/shapes/shapes.h"
#include "kernel/shapes/transform.h"
#include "kernel/triangles.h"

using namespace suture;

namespace {

Triangles ball_at(double x, double radius) {
  return translated(sphere({.radius = radius, .frequency = 8}), {x, 0, 0});
}

Triangles inside_out(Triangles surface) {
  for (Triangle& t : surface.triangles) std::swap(t[1], t[2]);
  return surface;
}

}  // namespace

TEST_CASE("a body that is gone has lost all, one that stays nothing, and one cut in half a half") {
  const std::vector<Triangles> three = {ball_at(0, 1), ball_at(5, 1),
                                        box({.size = {2, 1, 1}, .edge_length = 0.5})};
  const Triangles half = translated(box({.size = {1, 1, 1}, .edge_length = 0.5}), {0.5, 0, 0});
  const Triangles whole = translated(three[2], {0, 5, 0}), kept = translated(half, {0, 5, 0});
  const Triangles before = merged(std::vector<Triangles>{three[0], three[1], whole});
  const Triangles after = merged(std::vector<Triangles>{three[1], kept});
  const std::vector<BodyLoss> losses = body_losses(before, after);
  REQUIRE(losses.size() == 3);
  CHECK(losses[0].part == 1);
  CHECK(losses[1].part == 0);
  CHECK(losses[2].part == Approx(0.5).margin(0.02));
  CHECK(losses[1].centre[0] == Approx(5));
}

TEST_CASE("a sheet far thinner than any line's spacing is measured as a ball is") {
  const Triangles sheet = box({.size = {3, 2, 1e-6}, .edge_length = 0.5});
  CHECK(body_losses(sheet, sheet)[0].part == 0);
  CHECK(body_losses(sheet, {})[0].part == 1);
  const Triangles thinner = box({.size = {3, 2, 0.5e-6}, .edge_length = 0.5});
  CHECK(body_losses(sheet, thinner)[0].part == Approx(0.5).margin(0.01));
}

TEST_CASE("what another body covers is not lost, and a cavity loses what is filled") {
  const Triangles apart = merged(std::vector<Triangles>{ball_at(0, 1), ball_at(0.5, 1)});
  const Triangles one = ball_at(0, 1);
  const std::vector<BodyLoss> losses = body_losses(apart, one);
  REQUIRE(losses.size() == 2);
  CHECK(losses[0].part == 0);
  CHECK((losses[1].part > 0.3 && losses[1].part < 0.4));  // a lens of 0.63 of a ball is covered
  const Triangles hollow = merged(std::vector<Triangles>{ball_at(0, 2), inside_out(one)});
  const std::vector<BodyLoss> filled = body_losses(hollow, ball_at(0, 2));
  REQUIRE(filled.size() == 2);
  CHECK(filled[0].part == 0);
  CHECK(filled[1].volume < 0);
  CHECK(filled[1].part == 1);
}

TEST_CASE("only the components that are named are measured, in that order") {
  const Triangles before =
      merged(std::vector<Triangles>{ball_at(0, 1), ball_at(5, 1), ball_at(10, 1)});
  const std::vector<BodyLoss> losses = body_losses(before, ball_at(5, 1), {{2, 1}});
  REQUIRE(losses.size() == 2);
  CHECK((losses[0].component == 2 && losses[0].part == 1));
  CHECK((losses[1].component == 1 && losses[1].part == 0));
  CHECK(body_losses(before, before, BodyChoice{}).empty());
}

TEST_CASE("among many bodies the lost ones are still told from those that stay") {
  std::vector<Triangles> all, left;
  for (int i = 0; i < 900; ++i) {
    all.push_back(translated(sphere({.radius = 0.4, .frequency = 2}), {1.0 * i, 0, 0}));
    if (i % 3 != 0) left.push_back(all.back());
  }
  const std::vector<BodyLoss> losses = body_losses(merged(all), merged(left));
  REQUIRE(losses.size() == 900);
  std::size_t wrong = 0;
  for (std::size_t i = 0; i < losses.size(); ++i) wrong += losses[i].part != (i % 3 == 0 ? 1 : 0);
  CHECK(wrong == 0);
}
