// What a user can set about a run, by the names of the scene file's keys, and changes of it.
#include "sims/study/settings.h"

#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "kernel/errors.h"
#include "sims/output/report_json.h"

namespace suture::sims {
namespace {

using nlohmann::json;

Value value_of(const json& j) {
  if (j.is_boolean()) return j.get<bool>();
  if (j.is_number_integer()) return j.get<std::int64_t>();
  if (j.is_number()) return j.get<double>();
  if (j.is_string()) return j.get<std::string>();
  return j.get<std::vector<double>>();
}

void append(Settings& all, const std::string& table, const json& keys) {
  for (const auto& [key, value] : keys.items())
    if (!value.is_object()) all.push_back({table, key, value_of(value)});
}

}  // namespace

Settings settings_of(const Scene& scene) {
  TrackerOptions tracker = scene.tracker;
  if (tracker.quality.edge_length == 0) tracker.quality.edge_length = tracker.cell_size;
  const json options = to_json(tracker);
  Settings all;
  append(all, "tracker", options);
  append(all, "quality", options.at("quality"));
  append(all, "time",
         {{"step", scene.time.step},
          {"end", scene.time.end},
          {"remodel_every", scene.time.remodel_every},
          {"improve_every", scene.time.improve_every}});
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
