// A campaign's summary: counts that add up over disjoint ranges of seeds, and their JSON.
#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

namespace suture::sims {

/// A case to which a check objected; "crash" and "hang" count as checks.
struct FuzzFailure {
  std::uint64_t seed = 0;
  std::string check, cause;  ///< one line each
  std::string file;          ///< the minimal case in the corpus, if one was saved
};

struct SeedRange {
  std::uint64_t first = 0, cases = 0;
};

/// The asked settings; summaries are merged only where these are the same.
struct FuzzSettings {
  std::string version, profile, arithmetic, collapse, checks;
  double jitter = 0;

  bool operator==(const FuzzSettings&) const = default;
};

struct GeneratorTally {
  std::uint64_t cases = 0, remodels = 0, surgeries = 0;
};

struct FuzzSummary {
  FuzzSettings settings;
  std::vector<SeedRange> seeds;  ///< disjoint, in increasing order
  std::uint64_t cases = 0, remodels = 0;
  std::uint64_t surgeries = 0;     ///< remodels that changed the mesh
  std::uint64_t triangles = 0;     ///< of all surfaces after a remodel, together
  std::uint64_t largest_mesh = 0;  ///< triangles
  std::uint64_t digest = 0;        ///< of all final surfaces; the order of the cases is no matter
  std::map<std::string, std::uint64_t> operations;  ///< done, by kind and motion
  std::map<std::string, std::uint64_t> refused;     ///< remodels, by cause, its numbers as #
  std::map<std::string, std::uint64_t> ended;       ///< cases ended early, by cause: not failures
  std::map<std::string, std::uint64_t> checks;      ///< made, by name
  std::map<std::string, GeneratorTally> generators;
  std::vector<FuzzFailure> failures;  ///< by seed
  double cpu_seconds = 0, wall_seconds = 0;
};

/// Adds the counts, failures and seconds of `part`; not its settings or seeds.
void add_counts(FuzzSummary& sum, const FuzzSummary& part);

/// \throw InvalidInput if settings differ or a seed is in both
void merge(FuzzSummary& sum, const FuzzSummary& part);

nlohmann::json to_json(const FuzzSummary& summary);

/// \throw InvalidInput if it is not what to_json gives, with `name` and what is wrong
FuzzSummary summary_from_json(const nlohmann::json& json, const std::string& name);

/// \throw InvalidInput if the file cannot be read or is no summary
FuzzSummary read_summary(const std::filesystem::path& file);

/// The text with every number in it replaced by #, so that like causes are counted together.
std::string kind_of_cause(const std::string& cause);

}  // namespace suture::sims
