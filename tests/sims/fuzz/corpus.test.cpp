#include <catch2/catch.hpp>
#include <filesystem>

#include "kernel/shapes/shapes.h"
#include "sims/fuzz/case_file.h"
#include "sims/fuzz/case_maker.h"
#include "sims/fuzz/corpus.h"
#include "tests/paths.h"
#include "tests/sims/cli/program.h"

using namespace suture;
using namespace suture::sims;

namespace {

const CheckChoice kFast("fast");

}  // namespace

TEST_CASE("a case is run in a child of its own, which may crash or hang") {
  FuzzCase c = make_case(1, {});
  CHECK_FALSE(failure_of(c, kFast, 60));
  c.surface = sphere({Point::Zero(), 1, 0.1, 40});  // takes longer than a millisecond
  const auto slow = failure_of(c, kFast, 1e-9);
  REQUIRE(slow);
  CHECK(slow->check == "hang");
  c.operations.assign(1, {Operation::Kind::displace, {}});
  const auto thrown = failure_of(c, kFast, 60);  // "how" is missing
  REQUIRE(thrown);
  CHECK(thrown->check == "exception");
}

TEST_CASE("failures are saved, named in the summary, and fail again when they are replayed") {
  const Folder folder;
  FuzzSummary summary;
  for (std::uint64_t seed = 1; seed <= 3; ++seed)
    summary.failures.push_back({seed, "hang", "took more than 0 s", {}});

  save_failures(summary, [](std::uint64_t seed) { return make_case(seed, {}); },
                {folder / "corpus", kFast, {.seconds = 0.5, .trials = 10, .each = 2}});
  CHECK(folder.files() == 3);  // the folder and two cases
  CHECK(summary.failures[2].file.empty());
  const CorpusCase kept = read_case(summary.failures[0].file);
  CHECK(kept.check == "hang");
  CHECK(kept.fuzz_case.seed == 1);
}

TEST_CASE("every case of the corpus passes all checks") {
  const CheckChoice all("all");
  int cases = 0;
  for (const auto& entry : std::filesystem::directory_iterator(source_dir() + "/data/corpus")) {
    if (entry.path().extension() != ".toml") continue;
    ++cases;
    const CorpusCase c = read_case(entry.path());
    const FuzzSummary run = run_in_child(c.fuzz_case, all, 60);
    CAPTURE(entry.path(), c.cause, run.failures.empty() ? "" : run.failures[0].cause);
    CHECK(run.failures.empty());
    CHECK(run.ended.empty());  // all of it is run
    CHECK_FALSE(run.operations.empty());
    CHECK_FALSE(c.cause.empty());
  }
  CHECK(cases > 0);
}
