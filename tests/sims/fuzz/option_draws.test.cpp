#include <catch2/catch.hpp>
#include <map>
#include <set>

#include "kernel/errors.h"
#include "sims/fuzz/named_options.h"
#include "sims/fuzz/option_draws.h"

using namespace suture;
using namespace suture::sims;

namespace {

constexpr std::uint64_t kSeeds = 4000;

std::map<std::string, Value> drawn_values(std::uint64_t seed, const std::vector<OptionDraw>& how) {
  const auto list = named_values(draw_options(Draws(seed), how, CaseSize::usual));
  return {list.begin(), list.end()};
}

/// The values that an option has over many seeds, by how often.
std::map<Value, int> values_of(const std::string& option) {
  std::map<Value, int> counts;
  for (std::uint64_t seed = 1; seed <= kSeeds; ++seed)
    ++counts[drawn_values(seed, option_draws()).at(option)];
  return counts;
}

}  // namespace

TEST_CASE("every option is drawn, or it is said why not") {
  std::multiset<std::string> told;
  for (const OptionDraw& row : option_draws()) told.insert(row.option);
  for (const OptionNotDrawn& row : options_not_drawn()) {
    told.insert(row.option);
    CHECK_FALSE(row.reason.empty());
  }
  const auto names = option_names();
  CHECK(told == std::multiset<std::string>(names.begin(), names.end()));
}

TEST_CASE("each option is drawn as often as its line says, and is in its range") {
  std::map<std::string, int> others;
  for (std::uint64_t seed = 1; seed <= kSeeds; ++seed) {
    auto values = drawn_values(seed, option_draws());
    for (const OptionDraw& row : option_draws()) {
      const Value& value = values.at(row.option);
      const OptionInfo& option = option_named(row.option);
      REQUIRE(objection(option, value).empty());
      if (value == option.usual) continue;
      ++others[row.option];
      if (const auto* u = std::get_if<Uniform>(&row.how)) {
        REQUIRE(std::get<double>(value) >= u->low);
        REQUIRE(std::get<double>(value) <= u->high);
      }
      if (const auto* u = std::get_if<UniformCells>(&row.how)) {
        const double cells =
            std::get<double>(value) / std::get<double>(values.at("tracker.cell_size"));
        REQUIRE(cells >= u->low * (1 - 1e-15));
        REQUIRE(cells <= u->high * (1 + 1e-15));
      }
    }
  }
  for (const OptionDraw& row : option_draws()) {
    double part = 1 / static_cast<double>(row.once_in);  // of cases with another value than usual
    const double words = static_cast<double>(option_named(row.option).choices.size());
    if (std::holds_alternative<AnyWord>(row.how)) part *= 1 - 1 / words;
    if (const auto* whole = std::get_if<Whole>(&row.how))
      part *= 1 - 1.0 / (1 + whole->high - whole->low);
    CAPTURE(row.option);
    CHECK(others[row.option] / static_cast<double>(kSeeds) == Approx(part).margin(0.035));
  }
}

TEST_CASE("each word of an option occurs as often as the others") {
  for (const char* option : {"tracker.collapse", "tracker.placement", "quality.subdivision"}) {
    const auto counts = values_of(option);
    const std::size_t words = option_named(option).choices.size();
    CHECK(counts.size() == words);
    CAPTURE(option);
    for (const auto& [word, count] : counts)
      CHECK(count / static_cast<double>(kSeeds) ==
            Approx(1.0 / static_cast<double>(words)).margin(0.03));
  }
}

TEST_CASE("options that are drawn together are drawn in the same cases") {
  int together = 0;
  for (std::uint64_t seed = 1; seed <= kSeeds; ++seed) {
    const QualityOptions q = draw_options(Draws(seed), option_draws(), CaseSize::usual).quality;
    const QualityOptions usual;
    CHECK((q.chord_error == 0) == (q.finest == usual.finest));
    CHECK((q.longest == usual.longest) == (q.turn_bound == usual.turn_bound));
    CHECK((q.longest == usual.longest) == (q.largest_angle == usual.largest_angle));
    together += q.longest != usual.longest && q.chord_error != 0 ? 1 : 0;
  }
  CHECK(together / static_cast<double>(kSeeds) == Approx(1.0 / 12).margin(0.02));
}

TEST_CASE("a line more, or lines in another order, change no other option") {
  std::vector<OptionDraw> more(option_draws().rbegin(), option_draws().rend());
  more.push_back({"tracker.most_restarts", Whole{1, 50}, 2});
  int drawn = 0;
  for (std::uint64_t seed = 1; seed <= 300; ++seed) {
    auto before = drawn_values(seed, option_draws()), after = drawn_values(seed, more);
    drawn += before.at("tracker.most_restarts") != after.at("tracker.most_restarts") ? 1 : 0;
    before.erase("tracker.most_restarts");
    after.erase("tracker.most_restarts");
    CHECK(before == after);
  }
  CHECK(drawn > 100);
  CHECK(drawn < 200);
}

TEST_CASE("a line for an option that no table knows is refused") {
  CHECK_THROWS_AS(draw_options(Draws(1), {{"tracker.colour", Whole{1, 2}}}, CaseSize::usual),
                  InvalidInput);
}
