#include "sims/scene/reference.h"

#include <catch2/catch.hpp>
#include <map>
#include <set>

#include "kernel/files.h"
#include "sims/baselines/method_options.h"
#include "sims/flows/motion_options.h"
#include "sims/flows/motions.h"
#include "sims/fluid/options_table.h"
#include "sims/scene/option_tables.h"
#include "sims/scene/toml_keys.h"
#include "surgery/model/option_table.h"
#include "tests/option_checks.h"
#include "tests/paths.h"
#include "tests/sims/cli/program.h"

using namespace suture;
using namespace suture::sims;
using Catch::Matchers::Contains;
using Catch::Matchers::EndsWith;

namespace {

/// All tables of options that scenes are read by.
template <class Use>
void for_each_table(const Use& use) {
  use(tracker_options());
  use(quality_options());
  use(method_options());
  use(level_set_options());
  use(particle_level_set_options());
  use(contouring_options());
  use(time_options());
  use(mesh_options());
  use(picture_options());
  use(measure_options());
  use(placed_options());
  use(body_options());
  use(fluid_options());
  use(viscosity_options());
  use(viscoelasticity_options());
  use(surface_tension_options());
  use(volume_control_options());
  use(solid_options());
  use(box_solid_options());
  use(ball_solid_options());
  use(solid_motion_options());
  use(bodies_parameters());
  use(curl_noise_parameters());
  use(enright_parameters());
  use(fold_parameters());
  use(mean_curvature_parameters());
  use(normal_flow_parameters());
  use(reversal_parameters());
  use(rotation_parameters());
  use(stretch_parameters());
  use(translation_parameters());
}

Keys keys_of(const std::string& line) { return parse_toml(line, "scene.toml").keys; }

std::string line_of(const std::string& name, const Value& value) {
  return name + " = " + toml_of(value) + "\n";
}

/// Every option's first allowed value as TOML, read as options, whose values make the same TOML.
template <class Options>
void round_trip(const OptionTable<Options>& table) {
  std::string text, again;
  for (const auto& row : table.rows()) text += line_of(row.name, allowed_values(row.about).front());
  INFO(text);
  Keys keys = keys_of(text);
  Options options;
  read(keys, table, options);
  keys.done();
  for (const auto& [name, value] : values(options, table)) again += line_of(name, value);
  CHECK(again == text);
}

/// The keys of a table by its name, and those of all tables in it.
void collect(const TomlTable& table, const std::string& name,
             std::map<std::string, std::set<std::string>>& keys) {
  for (const std::string& key : table.keys.names()) keys[name].insert(key);
  const std::string start = name.empty() ? "" : name + ".";
  for (const auto& [inner, value] : table.tables) collect(value, start + inner, keys);
  for (const auto& [inner, list] : table.lists)
    for (const TomlTable& value : list) collect(value, start + inner, keys);
}

}  // namespace

TEST_CASE("every option of every table of a scene keeps its value and has its range checked") {
  for_each_table([](const auto& table) { check_table(table); });
}

TEST_CASE("every option of every table is read from TOML as it was written, and nothing else") {
  std::size_t read_back = 0;
  for_each_table([&](const auto& table) {
    for (const auto& row : table.rows())
      for (const Value& value : allowed_values(row.about)) {
        const std::string line = line_of(row.name, value);
        INFO(table.name() << ": " << line);
        Keys keys = keys_of(line);
        const std::optional<Value> given = keys.value(row.about);
        REQUIRE(given);
        keys.done();
        CHECK(as_held(row.about, *given) == as_held(row.about, value));
        ++read_back;
      }
  });
  CHECK(read_back > 250);
}

TEST_CASE("a table in TOML gives options whose values are the table again") {
  for_each_table([](const auto& table) { round_trip(table); });
}

TEST_CASE("a scene's value beyond each end of its range is refused by its key and line") {
  std::size_t refused = 0;
  for (const ReferenceSection& section : scene_reference()) {
    if (section.table == "bodies.parameters") continue;  // shapes check what they are given
    for (const OptionInfo& option : section.keys)
      for (const Value& value : refused_values(option)) {
        const std::string line = line_of(option.name, value);
        INFO(section.table << ": " << line);
        Keys keys = keys_of("\n" + line);
        CHECK_THROWS_WITH(keys.value(option),
                          Contains("scene.toml:2: " + option.name) && Contains("; "));
        ++refused;
      }
  }
  CHECK(refused > 400);
}

TEST_CASE("an option that must be given is refused where it is missing") {
  std::size_t missing = 0;
  for (const ReferenceSection& section : scene_reference())
    for (const OptionInfo& option : section.keys) {
      Keys none = keys_of("");
      INFO(option.name);
      if (option.required)
        CHECK_THROWS_WITH(none.value(option), Contains(option.name + ": is missing; give "));
      else
        CHECK_FALSE(none.value(option));
      missing += option.required ? 1 : 0;
    }
  CHECK(missing >= 7);
}

TEST_CASE("the reference of keys is what the program prints") {
  const std::string kept = read_file(source_dir() + "/data/scenes/REFERENCE.md");
  CHECK(kept == reference_page());
  const Said said = suture_program("keys");
  CHECK(said.exit == 0);
  CHECK(said.text == kept);
}

TEST_CASE("every key of the scenes that come with Suture is in the reference") {
  std::map<std::string, std::set<std::string>> known, used;
  for (const ReferenceSection& section : scene_reference())
    for (const OptionInfo& option : section.keys) known[section.table].insert(option.name);
  known["solids.parameters"] = known["bodies.parameters"];
  std::size_t scenes = 0;
  for (const auto& entry : std::filesystem::directory_iterator(source_dir() + "/data/scenes")) {
    if (entry.path().extension() != ".toml") continue;
    collect(parse_toml(read_file(entry.path()), entry.path()), "", used);
    ++scenes;
  }
  CHECK(scenes >= 11);
  for (const auto& [table, keys] : used)
    for (const std::string& key : keys) {
      INFO(table << "." << key);
      CHECK(known[table].count(key) == 1);
    }
}

TEST_CASE("a motion has no key that its parameters do not tell, and all that they do") {
  for (const std::string& kind : motion_names()) {
    std::string text;
    for (const OptionInfo& option : motion_parameters(kind))
      if (option.usual) text += line_of(option.name, *option.usual);
    INFO(kind << ":\n" << text);
    Keys keys = keys_of(text);
    CHECK_NOTHROW(make_motion(kind, keys, {}));
    Keys wrong = keys_of("no_such_key = 1\n");
    std::set<std::string> names;
    for (const OptionInfo& option : motion_parameters(kind)) names.insert(option.name);
    CHECK_THROWS_WITH(make_motion(kind, wrong, {}),
                      EndsWith("allowed here: " + joined({names.begin(), names.end()})));
  }
}
