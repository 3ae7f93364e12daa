// The settings of a run by the names of the scene file's keys, and changes of them.
#include "sims/study/settings.h"

#include <fmt/format.h>

#include <algorithm>

#include "kernel/errors.h"
#include "sims/scene/option_tables.h"
#include "surgery/model/option_table.h"

namespace suture::sims {
namespace {

/// Adds settings in the order of their names.
void append(Settings& all, const std::string& table,
            std::vector<std::pair<std::string, Value>> values) {
  std::sort(values.begin(), values.end(),
            [](const auto& a, const auto& b) { return a.first < b.first; });
  for (auto& [key, value] : values) all.push_back({table, key, std::move(value)});
}

}  // namespace

Settings settings_of(const Scene& scene) {
  QualityOptions quality = scene.tracker.quality;
  if (quality.edge_length == 0) quality.edge_length = scene.tracker.cell_size;
  Settings all;
  append(all, "tracker", values(scene.tracker, tracker_options()));
  append(all, "quality", values(quality, quality_options()));
  append(all, "time", values(scene.time, time_options()));
  return all;
}

const Setting& setting(const Settings& settings, const std::string& key) {
  std::vector<std::string> known;
  for (const Setting& s : settings) {
    if (s.key == key || s.full() == key) return s;
    known.push_back(s.key);
  }
  const std::string near = nearest_name(key, known);
  throw InvalidInput(fmt::format("there is no factor \"{}\"{}; there are resolution, {}", key,
                                 near.empty() ? "" : "; did you mean \"" + near + "\"?",
                                 joined(known)));
}

Settings changed(Settings settings, const SceneChanges& changes) {
  for (Setting& s : settings)
    if (const auto at = changes.find(s.full()); at != changes.end()) s.value = at->second;
  return settings;
}

std::string words_of(const Settings& settings, const SceneChanges& changes) {
  std::string words;
  for (const Setting& s : settings)
    if (const auto at = changes.find(s.full()); at != changes.end())
      words += (words.empty() ? "" : " ") + s.key + "=" + text_of(at->second);
  return words;
}

}  // namespace suture::sims
