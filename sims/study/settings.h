// The settings of a run by the names of the scene file's keys, and changes of them.
#pragma once

#include <string>
#include <vector>

#include "sims/scene/scene.h"

namespace suture::sims {

/// A key of [tracker], [quality] or [time]. No two of these have a key of the same name.
struct Setting {
  std::string table, key;
  Value value;

  std::string full() const { return table + "." + key; }  ///< as SceneChanges has it
};

/// Every setting, in the order of the tables; where the file says nothing, what then holds: an
/// edge_length of 0 is given as the cell size that it stands for.
using Settings = std::vector<Setting>;
Settings settings_of(const Scene& scene);

/// The setting called `key`, with or without its table. \throw InvalidInput, with the nearest name
const Setting& setting(const Settings& settings, const std::string& key);

/// The settings with the changes made. \pre the changes name settings
Settings changed(Settings settings, const SceneChanges& changes);

/// The changes as words, "cell_size=0.05 arithmetic=rational", in the order of the settings.
std::string words_of(const Settings& settings, const SceneChanges& changes);

}  // namespace suture::sims
