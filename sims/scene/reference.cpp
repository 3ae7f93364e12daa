// The reference of every key that a scene may have, made from the tables of options.
#include "sims/scene/reference.h"

#include <fmt/format.h>

#include <cmath>

#include "kernel/shapes/catalogue.h"
#include "sims/baselines/method_options.h"
#include "sims/flows/motions.h"
#include "sims/fluid/options_table.h"
#include "sims/scene/option_tables.h"
#include "surgery/model/option_table.h"

namespace suture::sims {
namespace {

using Sections = std::vector<ReferenceSection>;

void add_bodies(Sections& all) {
  all.push_back({"bodies", "A body; a list, given as [[bodies]].", infos(placed_options())});
  all.push_back({"bodies", "How often it is there, and how fast.", infos(body_options())});
  for (const ShapeInfo& shape : shape_catalogue()) {
    std::vector<OptionInfo> keys;
    for (const ShapeParameter& p : shape.parameters)
      keys.push_back({.name = p.name,
                      .meaning = p.meaning,
                      .unit = {p.unit.c_str()},
                      .type = OptionType::number,
                      .usual = p.value});
    all.push_back({"bodies.parameters",
                   "With shape = \"" + shape.name + "\": " + shape.meaning + ".", std::move(keys)});
  }
}

void add_motions(Sections& all) {
  all.push_back({"motion",
                 "What moves the surface; several motions are a list, given as [[motion]].",
                 infos(phase_options())});
  for (const std::string& kind : motion_names())
    if (std::vector<OptionInfo> keys = motion_parameters(kind); !keys.empty())
      all.push_back({"motion", "With kind = \"" + kind + "\".", std::move(keys)});
}

void add_methods(Sections& all) {
  all.push_back({"method", "What tracks the surface.", infos(method_options())});
  all.push_back({"method", "With kind = \"level_set\".", infos(level_set_options())});
  all.push_back(
      {"method", "With kind = \"particle_level_set\".", infos(particle_level_set_options())});
  all.push_back(
      {"method", "With kind = \"semi_lagrangian_contouring\".", infos(contouring_options())});
}

void add_fluid(Sections& all) {
  all.push_back(
      {"fluid", "A liquid that moves the surface, in place of a motion.", infos(fluid_options())});
  for (const EffectTable& effect : effect_tables())
    all.push_back({"fluid." + effect.name, effect.meaning, effect.options});
  all.push_back(
      {"solids", "A solid in the liquid; a list, given as [[solids]].", infos(solid_options())});
  all.push_back({"solids", "With kind = \"container\" or \"box\".", infos(box_solid_options())});
  all.push_back({"solids", "With kind = \"ball\".", infos(ball_solid_options())});
  all.push_back({"solids", "With kind = \"mesh\"; [solids.parameters] are those of a body.",
                 infos(placed_options())});
  all.push_back({"solids", "How it moves.", infos(solid_motion_options())});
}

std::string type_words(const OptionInfo& option) {
  switch (option.type) {
    case OptionType::flag:
      return "true or false";
    case OptionType::integer:
      return "integer";
    case OptionType::number:
      return "number";
    case OptionType::point:
      return "three numbers";
    case OptionType::list:
      return "list of numbers";
    case OptionType::choice:
      return "word";
    case OptionType::text:
      break;
  }
  return "text";
}

std::string range_words(const OptionInfo& option) {
  if (option.type == OptionType::choice) return joined(option.choices);
  if (option.type == OptionType::flag) return {};
  Range range = option.range;
  if (range.high == std::numeric_limits<int>::max()) range.high = Range().high;
  const bool bounded = std::isfinite(range.low) || std::isfinite(range.high);
  return (bounded ? range.words() : std::string()) + (range.infinite ? ", or inf" : "");
}

std::string default_words(const OptionInfo& option) {
  if (option.required) return "required";
  if (!option.otherwise.empty()) return option.otherwise;
  if (!option.usual) return {};
  const std::string words = in_words(*option.usual);
  return words == "[]" ? "none" : words;
}

std::string row(const OptionInfo& o) {
  return fmt::format("| `{}` | {} | {} | {} | {} | {} | {} |\n", o.name, type_words(o),
                     o.unit.words, range_words(o), default_words(o), o.meaning, o.source);
}

}  // namespace

std::vector<ReferenceSection> scene_reference() {
  Sections all = {{"", "Before any table.", infos(title_options())}};
  add_bodies(all);
  add_motions(all);
  all.push_back({"tracker", "The tracker's lattice and surgery.", infos(tracker_options())});
  all.push_back({"quality", "Improvement of the mesh.", infos(quality_options())});
  add_methods(all);
  all.push_back({"time", "Steps.", infos(time_options())});
  all.push_back({"meshes", "Meshes that are written.", infos(mesh_options())});
  all.push_back({"pictures", "Pictures that are drawn.", infos(picture_options())});
  all.push_back({"measure", "What `suture measure` looks at.", infos(measure_options())});
  add_fluid(all);
  return all;
}

std::string reference_page() {
  std::string page =
      "# Every key of a scene\n\n"
      "Printed by `suture keys` from the tables of options. Lengths, times and masses are in the "
      "scene's own units; `length` alone is the scene's unit of length. Sections (§) are those of "
      "Wojtan, Thürey, Gross and Turk 2009.\n";
  std::string table = "none yet";
  for (const ReferenceSection& section : scene_reference()) {
    if (section.table != table && !section.table.empty()) page += "\n## [" + section.table + "]\n";
    table = section.table;
    page += "\n" + section.words + "\n\n";
    if (section.keys.empty()) continue;
    page +=
        "| key | type | unit | range | default | meaning | source "
        "|\n|---|---|---|---|---|---|---|\n";
    for (const OptionInfo& key : section.keys) page += row(key);
  }
  return page;
}

}  // namespace suture::sims
