#include "surgery/model/option_table.h"

#include <catch2/catch.hpp>

#include "surgery/model/unit.h"
#include "surgery/tracker.h"
#include "tests/option_checks.h"
#include "tests/surgery/support.h"

using namespace suture;
using namespace suture::surgery;
using Catch::Matchers::Contains;

namespace {

TrackerOptions valid() { return {.cell_size = 0.5}; }

template <class Options>
std::vector<double> lengths(const Options& options, const OptionTable<Options>& table) {
  std::vector<double> all;
  for (const auto& row : table.rows()) {
    if (row.about.unit.length == 0) continue;
    const Value value = *row.field.get(options);
    if (const auto* list = std::get_if<std::vector<double>>(&value))
      all.insert(all.end(), list->begin(), list->end());
    else
      all.push_back(std::get<double>(value));
  }
  return all;
}

}  // namespace

TEST_CASE("every option of the tracker keeps what it is given and refuses what is out of range") {
  check_table(tracker_options());
  check_table(quality_options());
}

TEST_CASE("a tracker refuses every option of its tables beyond each end, by its name") {
  const Triangles surface = ball(1, Point::Zero(), 2);
  std::size_t refused = 0;
  const auto refuse = [&](const auto& row, const std::string& name, auto& part,
                          const TrackerOptions& options) {
    for (const Value& value : refused_values(row.about)) {
      const auto* list = std::get_if<std::vector<double>>(&value);
      if (value.index() != row.field.get(part)->index()) continue;  // the field cannot hold it
      if (list != nullptr && list->size() != 3) continue;
      if (row.about.type == OptionType::choice) continue;  // an enumeration holds nothing else
      row.field.set(part, value);
      INFO(in_words(value));
      CHECK_THROWS_WITH(Tracker(surface, options), Contains(name));
      ++refused;
    }
  };
  for (const auto& row : tracker_options().rows()) {
    TrackerOptions options = valid();
    refuse(row, row.name, options, options);
  }
  for (const auto& row : quality_options().rows()) {
    TrackerOptions options = valid();
    refuse(row, "quality." + row.name, options.quality, options);
  }
  CHECK(refused > 60);
}

TEST_CASE("a tracker takes every option at each end of its range") {
  const Triangles surface = ball(1, Point::Zero(), 2);
  const auto take = [&](const auto& table, auto part) {
    for (const auto& row : table.rows())
      for (const Value& value : allowed_values(row.about)) {
        if (row.about.unit.length != 0) continue;  // lengths must also suit the cells
        TrackerOptions options = valid();
        row.field.set(part(options), value);
        INFO(row.name << " = " << in_words(value));
        CHECK_NOTHROW(Tracker(surface, options));
      }
  };
  take(tracker_options(), [](TrackerOptions& o) -> TrackerOptions& { return o; });
  take(quality_options(), [](TrackerOptions& o) -> QualityOptions& { return o.quality; });
}

TEST_CASE("a power of two as the unit scales all lengths among the options and nothing else") {
  TrackerOptions options = valid();
  options.origin = {1, 2, 3};
  options.quality.edge_length = 5;
  options.quality.chord_error = 7;
  const TrackerOptions scaled = times_power(options, -3);
  CHECK(lengths(scaled, tracker_options()) == std::vector<double>{0.0625, 0.125, 0.25, 0.375});
  CHECK(lengths(scaled.quality, quality_options()) == std::vector<double>{0.625, 0.875});
  CHECK(scaled.jitter == options.jitter);
  CHECK(scaled.quality.longest == options.quality.longest);
}
