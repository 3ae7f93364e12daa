// Every trial of the minimiser runs in a child, so that a crash is a failure like another.
#include "sims/fuzz/corpus.h"

#include <fmt/format.h>

#include <cstring>
#include <nlohmann/json.hpp>

#include "kernel/files.h"
#include "sims/fuzz/case_file.h"
#include "sims/fuzz/execute.h"
#include "sims/support/process.h"

namespace suture::sims {

namespace {

template <class T>
void put(std::string& bytes, const std::vector<T>& list) {
  const std::uint64_t n = list.size();
  bytes.append(reinterpret_cast<const char*>(&n), sizeof n);
  if (n > 0) bytes.append(reinterpret_cast<const char*>(list.data()), n * sizeof(T));
}

template <class T>
bool take(const std::string& bytes, std::size_t& at, std::vector<T>& list) {
  std::uint64_t n = 0;
  if (bytes.size() - at < sizeof n) return false;
  std::memcpy(&n, bytes.data() + at, sizeof n);
  at += sizeof n;
  if ((bytes.size() - at) / sizeof(T) < n) return false;
  list.resize(n);
  if (n > 0) std::memcpy(static_cast<void*>(list.data()), bytes.data() + at, n * sizeof(T));
  at += n * sizeof(T);
  return true;
}

/// Thrown to end a run at the operation that was asked for.
struct Reached {};

Triangles surface_before(const FuzzCase& c, std::size_t operation, double seconds) {
  const Isolated run = run_isolated(
      [&] {
        std::string bytes;
        try {
          run_case(c, CheckChoice("fast"), [&](std::size_t index, const Triangles& surface) {
            if (index != operation) return;
            put(bytes, surface.positions);
            put(bytes, surface.triangles);
            throw Reached{};
          });
        } catch (const Reached&) {
        }
        return bytes;
      },
      seconds);
  Triangles surface;
  std::size_t at = 0;
  if (!take(run.text, at, surface.positions) || !take(run.text, at, surface.triangles)) return {};
  return surface;
}

/// Two failures are of one kind if the same check objected with the same words.
std::string kind_of(const FuzzFailure& failure) {
  return failure.check + ": " + kind_of_cause(failure.cause);
}

/// The check alone is asked again, so that trials are cheap; what the runner sees, it always sees.
CheckChoice only(const std::string& check, const CheckChoice& all) {
  for (const FuzzCheck& known : fuzz_checks())
    if (known.name == check) return CheckChoice(check);
  return check == "refused" || check == "exception" ? CheckChoice("fast") : all;
}

}  // namespace

FuzzSummary run_in_child(const FuzzCase& c, const CheckChoice& checks, double seconds) {
  const Isolated run =
      run_isolated([&] { return to_json(run_case(c, checks).counts).dump(); }, seconds);
  if (run.death.empty())
    return summary_from_json(nlohmann::json::parse(run.text), "a child's line");
  FuzzSummary died;
  died.cases = 1;
  if (run.death == "hang")
    died.failures.push_back(
        {c.seed, "hang", fmt::format("took more than {} s of a core", seconds), {}});
  else
    died.failures.push_back({c.seed, "crash", run.death, {}});
  return died;
}

std::optional<FuzzFailure> failure_of(const FuzzCase& c, const CheckChoice& checks,
                                      double seconds) {
  const FuzzSummary summary = run_in_child(c, checks, seconds);
  if (summary.failures.empty()) return std::nullopt;
  return summary.failures.front();
}

namespace {

/// \return the file
std::filesystem::path save_minimal(const FuzzFailure& failure, FuzzCase c,
                                   const CorpusOptions& options) {
  const CheckChoice asked = only(failure.check, options.checks);
  const double seconds = failure.check == "hang" ? 1 : options.limits.seconds;  // of one trial
  const std::string kind = kind_of(failure);
  const auto fails = [&](const FuzzCase& smaller) {
    const auto again = failure_of(smaller, asked, seconds);
    return again && kind_of(*again) == kind;
  };
  const auto before = [&](const FuzzCase& smaller, std::size_t operation) {
    return surface_before(smaller, operation, seconds);
  };
  CorpusCase kept{std::move(c), failure.check, failure.cause};
  if (fails(kept.fuzz_case))
    kept.fuzz_case = minimise(std::move(kept.fuzz_case), {fails, before}, options.limits).fuzz_case;
  if (const auto least = failure_of(kept.fuzz_case, asked, seconds)) kept.cause = least->cause;
  const auto file = options.folder / fmt::format("{}_{}.toml", failure.check, failure.seed);
  write_file(file, to_toml(kept));
  return file;
}

}  // namespace

void save_failures(FuzzSummary& summary, const std::function<FuzzCase(std::uint64_t)>& case_of,
                   const CorpusOptions& options) {
  std::filesystem::create_directories(options.folder);
  std::map<std::string, int> saved;
  for (FuzzFailure& failure : summary.failures) {
    if (++saved[kind_of(failure)] > options.limits.each) continue;
    FuzzCase c;
    try {
      c = case_of(failure.seed);
    } catch (const std::exception&) {
      continue;  // the generator itself broke down, as the failure says
    }
    failure.file = save_minimal(failure, std::move(c), options).string();
  }
}

}  // namespace suture::sims
