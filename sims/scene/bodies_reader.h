// A scene's bodies: shapes and mesh files, repaired where asked, placed, and checked.
#pragma once

#include "sims/scene/placed_shape.h"
#include "sims/scene/scene_sources.h"
#include "sims/scene/toml_keys.h"

namespace suture::sims {

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
