// The catalogue of shapes: parameters by name, and the refusal of bad ones.
#include "kernel/shapes/catalogue.h"

#include <catch2/catch.hpp>
#include <cmath>

#include "kernel/errors.h"
#include "kernel/shapes/transform.h"

using namespace suture;

TEST_CASE("shapes scale and move with their parameters") {
  const Triangles unit = make_shape("zalesak", {{"x", 0}, {"y", 0}, {"z", 0}});
  const Triangles twice = make_shape("zalesak", {{"x", 0},
                                                 {"y", 0},
                                                 {"z", 0},
                                                 {"radius", 30},
                                                 {"slot_width", 10},
                                                 {"slot_top", 20},
                                                 {"edge_length", 2}});
  CHECK(scaled(unit, 2) == twice);
  const Triangles moved = make_shape("torus", {{"x", 3}, {"y", -4}, {"z", 5}});
  CHECK(moved == translated(make_shape("torus", {}), {3, -4, 5}));
}

TEST_CASE("an unknown shape or parameter is refused with a list of what there is") {
  CHECK_THROWS_WITH(make_shape("cube", {}), Catch::Contains("\"cube\"") && Catch::Contains("box") &&
                                                Catch::Contains("animal"));
  CHECK_THROWS_AS(make_shape("box", {{"radius", 1}}), InvalidInput);
  CHECK_THROWS_WITH(make_shape("box", {{"radius", 1}}),
                    Catch::Contains("\"radius\"") && Catch::Contains("size_x"));
}

TEST_CASE("every parameter out of its range is refused") {
  const double nan = std::nan(""), infinite = 1 / 0.0;
  for (const ShapeInfo& shape : shape_catalogue())
    for (const ShapeParameter& p : shape.parameters) {
      INFO(shape.name << " " << p.name);
      CHECK_THROWS_AS(make_shape(shape.name, {{p.name, nan}}), InvalidInput);
      CHECK_THROWS_AS(make_shape(shape.name, {{p.name, infinite}}), InvalidInput);
      if (p.name == "edge_length") {
        CHECK_THROWS_AS(make_shape(shape.name, {{p.name, 0}}), InvalidInput);
        CHECK_THROWS_AS(make_shape(shape.name, {{p.name, -1}}), InvalidInput);
        CHECK_THROWS_AS(make_shape(shape.name, {{p.name, 1e-9}}), InvalidInput);
      }
    }
  CHECK_THROWS_AS(make_shape("sphere", {{"frequency", 1.5}}), InvalidInput);
  CHECK_THROWS_AS(make_shape("torus", {{"tube_radius", 1}}), InvalidInput);
  CHECK_THROWS_AS(make_shape("dumbbell", {{"distance", 0.5}}), InvalidInput);
  CHECK_THROWS_AS(make_shape("animal", {{"edge_length", 0.05}}), InvalidInput);
  CHECK_THROWS_AS(make_shape("sheet", {{"bend", 300}, {"thickness", 1}}), InvalidInput);
}
