// The runs that no other beats.
#include "sims/study/report/front.h"

#include <catch2/catch.hpp>

#include "tests/sims/study/trade_rows.h"

using namespace suture;
using namespace suture::sims;

namespace {

std::vector<int> numbers(const std::vector<Row>& rows, const std::vector<std::size_t>& indices) {
  std::vector<int> runs;
  for (const std::size_t i : indices) runs.push_back(run_number(rows[i]));
  return runs;
}

}  // namespace

TEST_CASE("the front holds the sound runs that no other beats, by cost") {
  const std::vector<Row> rows = planted_study();
  CHECK(numbers(rows, pareto_front(rows, kErrors[0], kCosts[0])) == std::vector<int>{1, 4, 5});
  CHECK(numbers(rows, pareto_front(rows, kErrors[0], kCosts[1])) == std::vector<int>{5});
  CHECK(pareto_front({}, kErrors[0], kCosts[0]).empty());
  CHECK(pareto_front({planted_crash(1, 1)}, kErrors[0], kCosts[0]).empty());
  const std::vector<Row> equal = {planted(1, 1, 0.5), planted(2, 1, 0.5), planted(3, 2, 0.5)};
  CHECK(numbers(equal, pareto_front(equal, kErrors[0], kCosts[0])) == std::vector<int>{1});
}
