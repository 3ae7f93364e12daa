// Values on the command line in place of a scene's own.
#pragma once

#include <CLI/CLI.hpp>

#include <string>
#include <vector>

#include "sims/scene/scene.h"

namespace suture::sims {

struct ChangeOptions {
  std::string method;                ///< empty: the scene's
  std::vector<std::string> changes;  ///< table.key=value
};

/// Adds --method and --set.
void add_change_options(CLI::App& command, ChangeOptions& options);

/// \throw InvalidInput for what is not table.key=value
SceneChanges read_changes(const ChangeOptions& options);

}  // namespace suture::sims
