// The classic meshes, where they are at hand: in $SUTURE_MODELS, data/models, or ../shared/models.
#pragma once

#include <cstdlib>
#include <filesystem>
#include <optional>
#include <string>

#include "kernel/formats/mesh_io.h"
#include "tests/paths.h"

namespace suture {

/// Where the mesh with this file name (as in data/models.toml, say "horse.ply") lies, or nothing.
inline std::optional<std::filesystem::path> classic_path(const std::string& file) {
  const std::filesystem::path source = source_dir();
  const char* const chosen = std::getenv("SUTURE_MODELS");
  for (const std::filesystem::path& folder :
       {std::filesystem::path(chosen != nullptr ? chosen : ""), source / "data" / "models",
        source / ".." / "shared" / "models"})
    if (!folder.empty() && std::filesystem::exists(folder / file)) return folder / file;
  return {};
}

/// That mesh, or nothing where it is not at hand: a test then says so and uses a shape of our own.
/// \throw InvalidInput if the file is there but cannot be read
inline std::optional<Triangles> classic(const std::string& file) {
  const auto path = classic_path(file);
  return path ? std::optional(read_triangles(*path)) : std::nullopt;
}

}  // namespace suture
