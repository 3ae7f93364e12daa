// What is drawn of a study.
#include "sims/study/report/plot.h"

#include <catch2/catch.hpp>

#include "tests/sims/study/trade_rows.h"

using namespace suture;
using namespace suture::sims;
using Catch::Matchers::Contains;

TEST_CASE("a plot's script marks failures, wrong topology and the front") {
  const std::string script = plot_script(planted_study(), {"It's a scene", 0.1, "a \"file\""});
  CHECK_THAT(script, Contains("'It''s a scene'") && Contains("failed: surgeries were refused"));
  CHECK_THAT(script, Contains("\n5 9 8\nEOD"));  // the lost run at the height of the worst error
}
