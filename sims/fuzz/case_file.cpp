// Options are written by the names that scenes and reports have for them, and read as a scene's.
#include "sims/fuzz/case_file.h"

#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "kernel/errors.h"
#include "kernel/files.h"
#include "sims/scene/scene.h"
#include "sims/scene/toml_keys.h"
#include "surgery/model/option_table.h"

namespace suture::sims {

namespace {

/// The number as TOML reads a float, with the sign of zero.
std::string number(double x) {
  std::string text = fmt::format("{}", x);
  if (text.find_first_of(".en") == std::string::npos) text += ".0";
  return text;
}

std::string quoted(const std::string& text) { return nlohmann::json(text).dump(); }

std::string written(const Value& value) {
  struct Writer {
    std::string operator()(bool b) const { return b ? "true" : "false"; }
    std::string operator()(std::int64_t i) const { return fmt::format("{}", i); }
    std::string operator()(double x) const { return number(x); }
    std::string operator()(const std::string& s) const { return quoted(s); }
    std::string operator()(const std::vector<double>& list) const {
      std::string text = "[";
      for (const double x : list) text += (text.size() > 1 ? ", " : "") + number(x);
      return text + "]";
    }
  };
  return std::visit(Writer{}, value);
}

/// The options, one a line, in alphabetical order.
template <class Options>
std::string lines_of(const Options& options, const OptionTable<Options>& table) {
  const auto list = values(options, table);
  const std::map<std::string, Value> sorted(list.begin(), list.end());
  std::string text;
  for (const auto& [key, value] : sorted) text += fmt::format("{} = {}\n", key, written(value));
  return text;
}

std::string surface_toml(const Triangles& surface) {
  std::string text = "[surface]\npositions = [\n";
  for (const Point& p : surface.positions)
    text += fmt::format("  {}, {}, {},\n", number(p[0]), number(p[1]), number(p[2]));
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
  text +=
      fmt::format("cause = {}\noracle = {}\nseed = \"{}\"\nprofile = {}\ngenerator = {}\n\n",
                  quoted(c.cause), quoted(c.check), f.seed, quoted(f.profile), quoted(f.generator));
  text += "[options]\n" + lines_of(f.options, tracker_options());
  text += "\n[quality]\n" + lines_of(f.options.quality, quality_options()) + "\n";
  for (const Operation& operation : f.operations) {
    text += "[[operations]]\n";
    for (const auto& named : kOperationNames)
      if (named.value == operation.kind) text += fmt::format("do = \"{}\"\n", named.name);
    for (const auto& [key, value] : operation.values)
      text += fmt::format("{} = {}\n", key, written(value));
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
  c.check = toml.keys.text("oracle", "");
  c.fuzz_case.seed = read_seed(toml.keys);
  c.fuzz_case.profile = toml.keys.text("profile", "");
  c.fuzz_case.generator = toml.keys.text("generator", "");
  toml.keys.done();
  c.fuzz_case.options = read_tracker(toml.tables.at("options").keys);
  c.fuzz_case.options.quality = read_quality(toml.tables.at("quality").keys);
  for (TomlTable& one : toml.lists["operations"])
    c.fuzz_case.operations.push_back(read_operation(one));
  c.fuzz_case.surface = read_surface(toml.tables.at("surface"));
  return c;
}

}  // namespace suture::sims
