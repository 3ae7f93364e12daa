// A scene's bodies: shapes and mesh files, repaired where asked, placed, and checked.
#pragma once

#include "sims/scene/placed_shape.h"
#include "sims/scene/scene_sources.h"
#include "sims/scene/toml_keys.h"

namespace suture::sims {

/// Where the surface of a body or a solid comes from, and how it is placed.
struct PlacedOptions {
  std::optional<std::string> shape, mesh, model;  ///< one of them
  std::optional<std::string> fallback;            ///< the shape where there is no such model
  double fallback_rotate = 0;                     ///< degrees
  Point fallback_rotate_axis = Point::UnitZ();
  bool repair = false, normalise = false;
  double scale = 1, rotate = 0;  ///< a factor, and degrees
  Point rotate_axis = Point::UnitZ(), translate = Point::Zero();
};

/// How often a body is there, and how fast it is.
struct BodyOptions {
  Point velocity = Point::Zero();
  std::int64_t copies = 1;
  std::int64_t scatter_seed = 1;
  Point scatter_low = Point::Zero();
  std::optional<Point> scatter_high;  ///< none: scatter_low
};

/// All bodies of a scene as one surface, what each is, the velocity of each vertex and notes for
/// the user.
struct Bodies {
  Triangles surface;
  std::vector<Point> velocities;
  std::vector<std::string> notes;
  std::vector<PlacedShape> shapes;
};

/// A body, or a solid: where its surface comes from, repaired if asked, placed; reads all keys that
/// say so and leaves the rest. \throw InvalidInput as read_scene
struct PlacedSurface {
  Triangles surface;
  PlacedShape is;
};
PlacedSurface read_placed(TomlTable& body, const std::filesystem::path& folder,
                          const SceneSources& sources, std::vector<std::string>& notes);

/// Reads [[bodies]]; `folder` is the scene's own, which paths are relative to.
/// \throw InvalidInput as read_scene
Bodies read_bodies(TomlTable& scene, const std::filesystem::path& folder,
                   const SceneSources& sources);

}  // namespace suture::sims
