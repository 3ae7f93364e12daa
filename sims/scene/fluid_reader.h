// The tables [fluid] and [[solids]] of a scene.
#pragma once

#include <memory>

#include "sims/fluid/fluid_options.h"
#include "sims/scene/scene_sources.h"
#include "sims/scene/toml_keys.h"
#include "surgery/model/options.h"

namespace suture::sims {

/// Null if the scene has no table [fluid]; it may then have no solids either. An effect is an
/// inner table, as [fluid.viscosity], and exists only if that is there. `notes` are for the user.
/// \throw InvalidInput as read_scene
std::shared_ptr<const FluidOptions> read_fluid(TomlTable& scene, const TrackerOptions& tracker,
                                               const std::filesystem::path& folder,
                                               const SceneSources& sources,
                                               std::vector<std::string>& notes);

}  // namespace suture::sims
