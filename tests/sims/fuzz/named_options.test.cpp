#include <catch2/catch.hpp>
#include <set>

#include "kernel/errors.h"
#include "sims/fuzz/named_options.h"
#include "surgery/model/option_table.h"

using namespace suture;
using namespace suture::sims;

TEST_CASE("every option of both tables has a full name, which sets it and gives it back") {
  const auto names = option_names();
  CHECK(names.size() == tracker_options().rows().size() + quality_options().rows().size());
  CHECK(std::set<std::string>(names.begin(), names.end()).size() == names.size());
  for (const std::string& name : names)
    if (const auto& usual = option_named(name).usual) {
      TrackerOptions options;
      set_option(options, name, *usual);
      CAPTURE(name);
      CHECK(named_values(options) == named_values({}));
    }
  TrackerOptions options;
  set_option(options, "quality.passes", std::int64_t{2});
  set_option(options, "tracker.collapse", std::string("paper"));
  CHECK(options.quality.passes == 2);
  CHECK(options.collapse == Collapse::paper);
  CHECK(named_values(options) != named_values({}));
}

TEST_CASE("a name without a table, a wrong table and a wrong value are refused") {
  TrackerOptions options;
  for (const char* name : {"depth", "trackers.depth", "tracker.dept", "quality.depth", ""}) {
    CAPTURE(name);
    CHECK_THROWS_AS(set_option(options, name, std::int64_t{1}), InvalidInput);
    CHECK_THROWS_AS(option_named(name), InvalidInput);
  }
  CHECK_THROWS_AS(set_option(options, "tracker.depth", std::int64_t{-1}), InvalidInput);
  CHECK(named_values(options) == named_values({}));
}

TEST_CASE("lengths among the options are scaled by a power of two, and nothing else is") {
  TrackerOptions options;
  options.cell_size = 0.3;
  options.origin = Point(1, 2, 3);
  options.quality.edge_length = 0.7;
  options.quality.chord_error = 0.01;
  TrackerOptions scaled = options;
  scale_lengths(scaled, -3);
  CHECK(scaled.cell_size == 0.3 / 8);
  CHECK(scaled.origin == options.origin / 8);
  CHECK(scaled.quality.edge_length == 0.7 / 8);
  CHECK(scaled.quality.chord_error == 0.01 / 8);
  scaled.cell_size = 0.3;
  scaled.origin = options.origin;
  scaled.quality.edge_length = 0.7;
  scaled.quality.chord_error = 0.01;
  CHECK(named_values(scaled) == named_values(options));
}
