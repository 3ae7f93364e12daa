// Options are written by the names that scenes and reports have for them, and read as a scene's.
#include "sims/fuzz/case_file.h"

#include <fmt/format.h>

#include "kernel/errors.h"
#include "kernel/files.h"
#include "sims/scene/scene.h"
#include "sims/scene/toml_keys.h"
#include "surgery/model/option_table.h"

namespace suture::sims {

namespace {

/// The options of a table as lines of TOML, in alphabetical order.
template <class Options>
std::string lines_of(const Options& options, const OptionTable<Options>& table) {
  const auto all = values(options, table);
  std::string text;
  for (const auto& [key, value] : std::map<std::string, Value>(all.begin(), all.end()))
    text += fmt::format("{} = {}\n", key, toml_of(value));
  return text;
}

std::string surface_toml(const Triangles& surface) {
  std::string text = "[surface]\npositions = [\n";
  for (const Point& p : surface.positions)
    text += fmt::format("  {}, {}, {},\n", toml_of(p[0]), toml_of(p[1]), toml_of(p[2]));
  text += "]\ntriangles = [\n";
  for (const Triangle& t : surface.triangles)
    text += fmt::format("  {}, {}, {},\n", t[0], t[1], t[2]);
  return text + "]\n";
}

Operation read_operation(TomlTable& table) {
  table.allow_tables({});
  Operation operation;
  operation.values = table.keys.values();
  operation.kind = table.keys.choice("do", kOperationNames, operation.kind);
  operation.values.erase("do");
  return operation;
}

Triangles read_surface(TomlTable& table) {
  table.allow_tables({});
  const std::vector<double> x = table.keys.list("positions", Range::any());
  constexpr double kMostIndex = 4294967294.0;
  const std::vector<double> v = table.keys.list("triangles", Range::between(0, kMostIndex));
  table.keys.done();
  if (x.size() % 3 != 0) table.keys.refuse("positions", "is not a list of threes");
  if (v.size() % 3 != 0) table.keys.refuse("triangles", "is not a list of threes");
  Triangles surface;
  for (std::size_t i = 0; i < x.size(); i += 3)
    surface.positions.emplace_back(x[i], x[i + 1], x[i + 2]);
  for (std::size_t i = 0; i < v.size(); i += 3)
    surface.triangles.push_back({static_cast<std::uint32_t>(v[i]),
                                 static_cast<std::uint32_t>(v[i + 1]),
                                 static_cast<std::uint32_t>(v[i + 2])});
  return surface;
}

std::uint64_t read_seed(Keys& keys) {
  const std::string text = keys.text("seed", "0");
  if (text.empty() || text.size() > 20 || text.find_first_not_of("0123456789") != std::string::npos)
    keys.refuse("seed", "is \"" + text + "\"; give a whole number in quotes");
  return std::stoull(text);
}

}  // namespace

std::string to_toml(const CorpusCase& c) {
  const FuzzCase& f = c.fuzz_case;
  std::string text = fmt::format("# {}\n# Replay it with: suture fuzz --replay FILE\n",
                                 c.cause.empty() ? "A case of suture fuzz." : c.cause);
  text += fmt::format("cause = {}\noracle = {}\nseed = \"{}\"\nprofile = {}\ngenerator = {}\n\n",
                      toml_of(c.cause), toml_of(c.oracle), f.seed, toml_of(f.profile),
                      toml_of(f.generator));
  text += "[options]\n" + lines_of(f.options, tracker_options());
  text += "\n[quality]\n" + lines_of(f.options.quality, quality_options()) + "\n";
  for (const Operation& operation : f.operations) {
    text += "[[operations]]\n";
    for (const auto& named : kOperationNames)
      if (named.value == operation.kind) text += fmt::format("do = \"{}\"\n", named.name);
    for (const auto& [key, value] : operation.values)
      text += fmt::format("{} = {}\n", key, toml_of(value));
    text += "\n";
  }
  return text + surface_toml(f.surface);
}

CorpusCase read_case(const std::filesystem::path& file) {
  TomlTable toml = parse_toml(read_file(file), file);
  toml.allow_tables({"options", "quality", "operations", "surface"});
  for (const char* needed : {"options", "quality", "surface"})
    if (toml.tables.count(needed) == 0)
      throw InvalidInput(fmt::format("{}: [{}] is missing; give a case as suture fuzz writes it",
                                     file.string(), needed));
  CorpusCase c;
  c.cause = toml.keys.text("cause", "");
  c.oracle = toml.keys.text("oracle", "");
  c.fuzz_case.seed = read_seed(toml.keys);
  c.fuzz_case.profile = toml.keys.text("profile", "");
  c.fuzz_case.generator = toml.keys.text("generator", "");
  toml.keys.done();
  c.fuzz_case.options = read_all(toml.tables.at("options").keys, tracker_options());
  c.fuzz_case.options.quality = read_all(toml.tables.at("quality").keys, quality_options());
  for (TomlTable& one : toml.lists["operations"])
    c.fuzz_case.operations.push_back(read_operation(one));
  c.fuzz_case.surface = read_surface(toml.tables.at("surface"));
  return c;
}

}  // namespace suture::sims
