// Counts are added, ranges of seeds are kept apart and joined where they touch.
#include "sims/fuzz/summary.h"

#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "kernel/errors.h"
#include "kernel/files.h"

namespace suture::sims {

namespace {

using nlohmann::json;

template <class Map>
void add(Map& sum, const Map& part) {
  for (const auto& [name, count] : part) sum[name] += count;
}

bool overlap(const SeedRange& a, const SeedRange& b) {
  return a.first < b.first ? b.first - a.first < a.cases : a.first - b.first < b.cases;
}

/// The ranges in increasing order, joined where they touch.
std::vector<SeedRange> tidied(std::vector<SeedRange> ranges) {
  std::sort(ranges.begin(), ranges.end(),
            [](const SeedRange& a, const SeedRange& b) { return a.first < b.first; });
  std::vector<SeedRange> result;
  for (const SeedRange& r : ranges)
    if (!result.empty() && result.back().first + result.back().cases == r.first)
      result.back().cases += r.cases;
    else if (r.cases > 0)
      result.push_back(r);
  return result;
}

double per_second(std::uint64_t count, double seconds) {
  return seconds > 0 ? static_cast<double>(count) / seconds : 0;
}

std::uint64_t count_of(const FuzzSummary& s, const std::string& check) {
  return static_cast<std::uint64_t>(
      std::count_if(s.failures.begin(), s.failures.end(),
                    [&](const FuzzFailure& f) { return f.check == check; }));
}

json checks_json(const FuzzSummary& s) {
  json result = json::object();
  for (const auto& [name, count] : s.checks)
    result[name] = {{"checks", count}, {"failures", count_of(s, name)}};
  for (const FuzzFailure& f : s.failures)
    if (!result.contains(f.check))
      result[f.check] = {{"checks", 0}, {"failures", count_of(s, f.check)}};
  return result;
}

}  // namespace

void add_counts(FuzzSummary& sum, const FuzzSummary& part) {
  sum.cases += part.cases;
  sum.remodels += part.remodels;
  sum.surgeries += part.surgeries;
  sum.triangles += part.triangles;
  sum.largest_mesh = std::max(sum.largest_mesh, part.largest_mesh);
  sum.digest += part.digest;
  add(sum.operations, part.operations);
  add(sum.refused, part.refused);
  add(sum.ended, part.ended);
  add(sum.checks, part.checks);
  for (const auto& [name, tally] : part.generators) {
    GeneratorTally& g = sum.generators[name];
    g.cases += tally.cases;
    g.remodels += tally.remodels;
    g.surgeries += tally.surgeries;
  }
  sum.failures.insert(sum.failures.end(), part.failures.begin(), part.failures.end());
  std::stable_sort(sum.failures.begin(), sum.failures.end(),
                   [](const FuzzFailure& a, const FuzzFailure& b) { return a.seed < b.seed; });
  sum.cpu_seconds += part.cpu_seconds;
  sum.wall_seconds += part.wall_seconds;
}

void merge(FuzzSummary& sum, const FuzzSummary& part) {
  if (!(sum.settings == part.settings))
    throw InvalidInput(
        "the summaries are of campaigns with different settings (version, profile, arithmetic, "
        "collapse, oracles or jitter); merge only those that are alike");
  for (const SeedRange& a : sum.seeds)
    for (const SeedRange& b : part.seeds)
      if (overlap(a, b))
        throw InvalidInput(
            fmt::format("the summaries share seeds ({} from {} on, and {} from {} on); merge only "
                        "disjoint ranges",
                        a.cases, a.first, b.cases, b.first));
  sum.seeds.insert(sum.seeds.end(), part.seeds.begin(), part.seeds.end());
  sum.seeds = tidied(std::move(sum.seeds));
  add_counts(sum, part);
}

json to_json(const FuzzSummary& s) {
  json seeds = json::array(), failures = json::array(), generators = json::object();
  for (const SeedRange& r : s.seeds) seeds.push_back({{"first", r.first}, {"cases", r.cases}});
  for (const FuzzFailure& f : s.failures)
    failures.push_back(
        {{"seed", f.seed}, {"oracle", f.check}, {"cause", f.cause}, {"file", f.file}});
  for (const auto& [name, g] : s.generators)
    generators[name] = {{"cases", g.cases}, {"remodels", g.remodels}, {"surgeries", g.surgeries}};
  return {{"version", s.settings.version},
          {"profile", s.settings.profile},
          {"arithmetic", s.settings.arithmetic},
          {"collapse", s.settings.collapse},
          {"oracles_asked", s.settings.checks},
          {"jitter", s.settings.jitter},
          {"seeds", seeds},
          {"cases", s.cases},
          {"remodels", s.remodels},
          {"surgeries", s.surgeries},
          {"triangles", s.triangles},
          {"largest_mesh", s.largest_mesh},
          {"digest", fmt::format("{:016x}", s.digest)},
          {"operations", s.operations},
          {"refused", s.refused},
          {"ended_early", s.ended},
          {"oracles", checks_json(s)},
          {"generators", generators},
          {"failures", failures},
          {"crashes", count_of(s, "crash")},
          {"hangs", count_of(s, "hang")},
          {"cpu_seconds", s.cpu_seconds},
          {"wall_seconds", s.wall_seconds},
          {"surgeries_per_second", per_second(s.surgeries, s.wall_seconds)},
          {"surgeries_per_cpu_second", per_second(s.surgeries, s.cpu_seconds)}};
}

FuzzSummary summary_from_json(const json& j, const std::string& name) try {
  FuzzSummary s;
  s.settings = {j.at("version"),  j.at("profile"),       j.at("arithmetic"),
                j.at("collapse"), j.at("oracles_asked"), j.at("jitter")};
  for (const json& r : j.at("seeds")) s.seeds.push_back({r.at("first"), r.at("cases")});
  s.cases = j.at("cases");
  s.remodels = j.at("remodels");
  s.surgeries = j.at("surgeries");
  s.triangles = j.at("triangles");
  s.largest_mesh = j.at("largest_mesh");
  s.digest = std::stoull(j.at("digest").get<std::string>(), nullptr, 16);
  s.operations = j.at("operations");
  s.refused = j.at("refused");
  s.ended = j.at("ended_early");
  for (const auto& [check, counts] : j.at("oracles").items())
    if (counts.at("checks") != 0) s.checks[check] = counts.at("checks");
  for (const auto& [generator, g] : j.at("generators").items())
    s.generators[generator] = {g.at("cases"), g.at("remodels"), g.at("surgeries")};
  for (const json& f : j.at("failures"))
    s.failures.push_back({f.at("seed"), f.at("oracle"), f.at("cause"), f.at("file")});
  s.cpu_seconds = j.at("cpu_seconds");
  s.wall_seconds = j.at("wall_seconds");
  return s;
} catch (const std::exception& error) {
  throw InvalidInput(name + " is no summary of suture fuzz: " + error.what());
}

FuzzSummary read_summary(const std::filesystem::path& file) {
  const json parsed = json::parse(read_file(file), nullptr, false);
  if (parsed.is_discarded())
    throw InvalidInput(file.string() + " is not JSON; give a summary that suture fuzz wrote");
  return summary_from_json(parsed, file.string());
}

std::string kind_of_cause(const std::string& cause) {
  std::string kind;
  for (const char c : cause.substr(0, cause.find('\n')))
    if (std::isdigit(static_cast<unsigned char>(c)) == 0)
      kind += c;
    else if (kind.empty() || kind.back() != '#')
      kind += '#';
  return kind;
}

}  // namespace suture::sims
