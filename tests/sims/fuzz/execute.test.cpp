#include <catch2/catch.hpp>

#include "kernel/shapes/shapes.h"
#include "sims/fuzz/displacement.h"
#include "sims/fuzz/execute.h"

using namespace suture;
using namespace suture::sims;

namespace {

using Kind = Operation::Kind;

/// A ball that is remodelled, moved and remodelled again.
FuzzCase ball_case() {
  FuzzCase c;
  c.seed = 5;
  c.generator = "a ball";
  c.surface = sphere({Point(0.01, 0.02, 0.03), 1, 0.1, 3});
  c.options.cell_size = 0.31;
  c.operations = {{Kind::remodel, {}},
                  {Kind::advance, {{"motion", std::string("rotation")}, {"dt", 0.1}}},
                  displacement({Perturb::noise, 0.2, 1, 3}),
                  {Kind::improve, {}},
                  {Kind::remodel, {}}};
  return c;
}

}  // namespace

TEST_CASE("a case is run to its end, and each operation is counted by its name") {
  std::vector<std::size_t> seen;
  const CaseRun run = run_case(ball_case(), CheckChoice("all"),
                               [&](std::size_t index, const Triangles&) { seen.push_back(index); });
  CHECK(run.counts.failures.empty());
  CHECK(run.counts.ended.empty());
  CHECK(run.operations == 5);
  CHECK(seen == std::vector<std::size_t>{0, 1, 2, 3, 4});
  CHECK(run.counts.operations ==
        std::map<std::string, std::uint64_t>{
            {"advance rotation", 1}, {"displace noise", 1}, {"improve", 1}, {"remodel", 2}});
  CHECK(run.counts.generators.at("a ball").remodels == 2);
  CHECK(run.counts.checks.at("audit") == 5);
  CHECK(run.counts.checks.at("order") == 5);
}

TEST_CASE("the digest of a case depends on its last surface and on its seed") {
  const FuzzCase c = ball_case();
  FuzzCase other = c, reseeded = c;
  other.operations.pop_back();
  other.operations.pop_back();
  ++reseeded.seed;
  const std::uint64_t digest = run_case(c, CheckChoice("fast")).counts.digest;
  CHECK(digest == run_case(c, CheckChoice("audit")).counts.digest);
  CHECK(digest != run_case(other, CheckChoice("fast")).counts.digest);
  CHECK(digest != run_case(reseeded, CheckChoice("fast")).counts.digest);
}

TEST_CASE("what the tracker refuses as bad input, or what costs too much, ends a case early") {
  FuzzCase bad = ball_case();
  bad.operations[1].values["dt"] = 1e308;
  const CaseRun refused = run_case(bad, CheckChoice("fast"));
  CHECK(refused.counts.failures.empty());
  CHECK(refused.counts.ended.size() == 1);
  CHECK(refused.operations == 2);
  FuzzCase costly = ball_case();
  costly.options.cell_size = 1e-3;
  const CaseRun left = run_case(costly, CheckChoice("fast"));
  CHECK(left.counts.ended.count("too costly for a fuzzer") == 1);
  CHECK(left.operations == 0);
}

TEST_CASE("an operation that throws anything but bad input is a failure") {
  FuzzCase c = ball_case();
  c.operations[2].values.erase("how");
  const CaseRun run = run_case(c, CheckChoice("fast"));
  REQUIRE(run.counts.failures.size() == 1);
  CHECK(run.counts.failures[0].check == "exception");
  CHECK(run.operations == 3);
}
