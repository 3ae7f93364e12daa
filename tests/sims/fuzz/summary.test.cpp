#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>

#include "kernel/errors.h"
#include "sims/fuzz/campaign.h"
#include "tests/sims/fuzz/counted.h"

using namespace suture;
using namespace suture::sims;

TEST_CASE("two halves of a campaign merge to the whole, through their JSON") {
  FuzzSummary whole = run_campaign({.first = 1, .cases = 150}, real);
  FuzzSummary sum = summary_from_json(to_json(run_campaign({.first = 81, .cases = 70}, real)), "b");
  merge(sum, summary_from_json(to_json(run_campaign({.first = 1, .cases = 80}, real)), "a"));
  CHECK(without_seconds(sum) == without_seconds(whole));
}

TEST_CASE("summaries that share seeds or differ in what was asked are not merged") {
  FuzzSummary a = run_campaign({.first = 1, .cases = 10}, counted);
  FuzzSummary b = run_campaign({.first = 10, .cases = 10}, counted);
  CHECK_THROWS_AS(merge(a, b), InvalidInput);
  FuzzSummary c = run_campaign({.first = 11, .cases = 10}, counted);
  c.settings.arithmetic = "rounded";
  CHECK_THROWS_AS(merge(a, c), InvalidInput);
  c.settings = a.settings;
  merge(a, c);
  CHECK(a.cases == 20);
  CHECK(a.seeds.size() == 1);
  CHECK(a.refused["a cause"] == 20);
  CHECK_THROWS_AS(summary_from_json(nlohmann::json{{"cases", 3}}, "x"), InvalidInput);
}

TEST_CASE("causes that differ in numbers only are one kind") {
  CHECK(kind_of_cause("audit: edge 12-7 has 3 triangles\nmore") ==
        "audit: edge #-# has # triangles");
}
