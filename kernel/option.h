// One option in words: its name, meaning, unit, range, default and source.
#pragma once

#include <cstdint>
#include <limits>
#include <optional>
#include <string>
#include <variant>
#include <vector>

namespace suture {

/// The value of an option, or of a key in a file. Numbers in lists are doubles.
using Value = std::variant<bool, std::int64_t, double, std::string, std::vector<double>>;

/// Numbers have the fewest digits that read back to the same bits, texts have no quotes, lists have
/// brackets.
std::string in_words(const Value& value);

/// The value with its numbers × 2^exponent; anything else stays.
Value times_power(Value value, int exponent);

/// The numbers that an option allows, in its own unit.
struct Range {
  double low = -std::numeric_limits<double>::infinity();
  double high = std::numeric_limits<double>::infinity();
  bool open = false;      ///< `low` itself is not allowed
  bool infinite = false;  ///< inf is allowed

  static Range any() { return {}; }
  static Range above(double low) { return {low, std::numeric_limits<double>::infinity(), true}; }
  static Range at_least(double low) { return {low, std::numeric_limits<double>::infinity()}; }
  Range or_infinite() const {
    Range wider = *this;
    wider.infinite = true;
    return wider;
  }
  static Range between(double low, double high) { return {low, high}; }
  bool holds(double x) const { return (open ? x > low : x >= low) && x <= high; }
  std::string words() const;
};

/// A value that a user writes as a word.
template <class T>
struct Named {
  const char* name;
  T value;
};

/// A unit in words, and as powers of length, time and mass. The units of these are the scene's own.
struct Unit {
  const char* words = "";
  int length = 0, time = 0, mass = 0;
};

namespace unit {
inline constexpr Unit none{}, length{"length", 1}, time{"time", 0, 1};
inline constexpr Unit speed{"length/time", 1, -1}, acceleration{"length/time²", 1, -2};
inline constexpr Unit area_rate{"length²/time", 2, -1}, rate{"1/time", 0, -1};
inline constexpr Unit density{"mass/length³", -3, 0, 1}, pressure{"mass/(length·time²)", -1, -2, 1};
inline constexpr Unit viscosity{"mass/(length·time)", -1, -1, 1}, tension{"mass/time²", 0, -2, 1};
inline constexpr Unit degrees{"degrees"}, cells{"cells"}, steps{"steps"}, pixels{"pixels"};
}  // namespace unit

enum class OptionType { flag, integer, number, point, list, choice, text };

/// Everything about an option but its value. An author writes the first group; a table fills in
/// the second from the option's field.
struct OptionInfo {
  std::string name{};     ///< the one by which files, reports and flags call it
  std::string meaning{};  ///< a phrase that says what the value means
  Unit unit{};
  Range range{};            ///< of a number, or of each number in a list
  bool required = false;    ///< a file must give a value
  std::string otherwise{};  ///< words for the default, where another option decides it
  std::string source{};     ///< the paper's section, or the publication

  OptionType type = OptionType::flag;
  std::vector<std::string> choices{};  ///< the words that a choice allows
  std::optional<Value> usual{};        ///< the default; none where there is no value by default
};

/// The values that an option allows, as in "a number, from 0 to 1".
std::string allowed(const OptionInfo& option);

/// Says what is wrong with a value and what is allowed, as in "is -1; allowed is at least 0", or
/// nothing if the option allows it. A number may be given as an integer.
std::string objection(const OptionInfo& option, const Value& value);

/// The name among `known` that is nearest to `wrong` by edit distance, or empty if none is near.
std::string nearest_name(const std::string& wrong, const std::vector<std::string>& known);

/// Names joined for a message: "a, b, c".
std::string joined(const std::vector<std::string>& names);

}  // namespace suture
