// A scene's bodies: shapes and mesh files, repaired where asked, placed, and checked.
#pragma once

#include "sims/placed_shape.h"
#include "sims/scene_sources.h"
#include "sims/toml_keys.h"

namespace suture {

/// All bodies of a scene as one surface, what each is, the velocity of each vertex and notes for
/// the user.
struct Bodies {
  Triangles surface;
  std::vector<Point> velocities;
  std::vector<std::string> notes;
  std::vector<PlacedShape> shapes;
};

/// Reads [[bodies]]; `folder` is the scene's own, which paths are relative to.
/// \throw InvalidInput as read_scene
Bodies read_bodies(TomlTable& scene, const std::filesystem::path& folder,
                   const SceneSources& sources);

}  // namespace suture
