// What a scene may draw on: files, shapes, and as many triangles as can be held.
#pragma once

#include <filesystem>
#include <functional>
#include <map>
#include <string>

#include "kernel/formats/mesh_io.h"
#include "kernel/shapes/catalogue.h"
#include "kernel/shapes/shapes.h"

namespace suture::sims {

/// The file system and the catalogue of shapes by default. A program that reads scenes it does not
/// trust, or holds meshes in memory, gives its own; each may throw InvalidInput.
struct SceneSources {
  std::function<bool(const std::filesystem::path&)> is_file = [](const std::filesystem::path& p) {
    return std::filesystem::is_regular_file(p);
  };
  std::function<Triangles(const std::filesystem::path&)> read_mesh = read_triangles;
  std::function<Triangles(const std::string&, const std::map<std::string, double>&)> make_shape =
      suture::make_shape;
  double most_triangles = kMostTriangles;  ///< of all bodies together
};

}  // namespace suture::sims
