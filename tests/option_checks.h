// What every table of options must hold to, asked of each of its options.
#pragma once

#include <catch2/catch.hpp>
#include <cmath>
#include <limits>
#include <set>

#include "kernel/option_table.h"

namespace suture {

/// Values beyond each end of what an option allows, and of a wrong type.
inline std::vector<Value> refused_values(const OptionInfo& option) {
  constexpr double inf = std::numeric_limits<double>::infinity();
  const Range& r = option.range;
  std::vector<double> numbers = {std::nan(""), -inf};
  if (!r.infinite) numbers.push_back(inf);
  if (std::isfinite(r.low)) numbers.push_back(r.open ? r.low : std::nextafter(r.low, -inf));
  if (std::isfinite(r.high)) numbers.push_back(std::nextafter(r.high, inf));
  std::vector<Value> wrong;
  switch (option.type) {
    case OptionType::flag:
      return {std::int64_t{1}, std::string("true")};
    case OptionType::integer:
      wrong = {0.5, std::string("1")};
      if (std::isfinite(r.low)) wrong.emplace_back(static_cast<std::int64_t>(r.low) - 1);
      if (r.high < 1e18) wrong.emplace_back(static_cast<std::int64_t>(r.high) + 1);
      return wrong;
    case OptionType::number:
      wrong = {true, std::string("1")};
      for (const double x : numbers) wrong.emplace_back(x);
      return wrong;
    case OptionType::point:
      wrong = {1.0, std::vector<double>{1, 2}, std::vector<double>{1, 2, 3, 4}};
      for (const double x : numbers) wrong.emplace_back(std::vector<double>{0, x, 0});
      return wrong;
    case OptionType::list:
      wrong = {1.0};
      for (const double x : numbers) wrong.emplace_back(std::vector<double>{x});
      return wrong;
    case OptionType::choice:
      return {true, std::string("no such word"), std::string()};
    case OptionType::text:
      return {true, 1.0};
  }
  return wrong;
}

/// Values that the option allows, at the ends of its range and between; more than one wherever
/// there is more than one.
inline std::vector<Value> allowed_values(const OptionInfo& option) {
  constexpr double most = std::numeric_limits<double>::max();
  const Range& r = option.range;
  const double low = std::max(r.open ? std::nextafter(r.low, most) : r.low, -most);
  const double high = std::min(r.high, most), middle = low / 2 + high / 2;
  std::vector<Value> right;
  switch (option.type) {
    case OptionType::flag:
      return {false, true};
    case OptionType::integer:
      return {static_cast<std::int64_t>(std::max(low, -1e15)),
              static_cast<std::int64_t>(std::min(high, 1e15))};
    case OptionType::number:
      right = {low, middle, high, static_cast<std::int64_t>(std::min(high, 100.0))};
      if (r.infinite) right.emplace_back(std::numeric_limits<double>::infinity());
      return right;
    case OptionType::point:
      return {std::vector<double>{0.1, -2, 3}, std::vector<double>{1, 0, -0.0}};
    case OptionType::list:
      return {std::vector<double>{low, high}, std::vector<double>{}};
    case OptionType::choice:
      for (const std::string& word : option.choices) right.emplace_back(word);
      return right;
    case OptionType::text:
      return {std::string("word"), std::string("two \"words\"\n\\")};
  }
  return right;
}

/// Numbers as an option holds them: one that is given as an integer is a number afterwards.
inline Value as_held(const OptionInfo& option, const Value& value) {
  const auto* whole = std::get_if<std::int64_t>(&value);
  if (option.type == OptionType::number && whole != nullptr) return static_cast<double>(*whole);
  return value;
}

/// Checks that each option is described, that its default is allowed, that it keeps what it is
/// given and touches no other one, and that what is out of range is refused at each end.
template <class Options>
void check_table(const OptionTable<Options>& table) {
  REQUIRE_FALSE(table.rows().empty());
  std::set<std::string> names;
  for (const auto& row : table.rows()) {
    INFO(table.name() << "." << row.name);
    CHECK(names.insert(row.name).second);
    CHECK_FALSE(row.about.meaning.empty());
    if (row.about.usual && row.about.otherwise.empty())
      CHECK(objection(row.about, *row.about.usual) == "");
    for (const Value& value : refused_values(row.about)) {
      Options options;
      INFO(in_words(value));
      CHECK_FALSE(objection(row.about, value).empty());
      CHECK_THROWS_AS(set(options, table, row.name, value), InvalidInput);
    }
    for (const Value& value : allowed_values(row.about)) {
      Options options;
      auto expected = values(options, table);
      INFO(in_words(value));
      set(options, table, row.name, value);
      CHECK(row.field.get(options) == as_held(row.about, value));
      std::erase_if(expected, [&](const auto& other) { return other.first == row.name; });
      auto found = values(options, table);
      CHECK(std::erase_if(found, [&](const auto& one) { return one.first == row.name; }) == 1);
      CHECK(found == expected);
    }
  }
}

}  // namespace suture
