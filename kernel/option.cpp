// One option in words: its name, meaning, unit, range, default and source.
#include "kernel/option.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>

#include "kernel/lists.h"

namespace suture {
namespace {

/// The fewest digits that read back to the same bits; an exponent only below 1e-4 and from 1e16 on.
std::string shortest(double x) {
  const double size = std::abs(x);
  const bool plain = size == 0 || (size >= 1e-4 && size < 1e16) || !std::isfinite(x);
  std::array<char, 64> text;
  const auto end = std::to_chars(text.data(), text.data() + text.size(), x,
                                 plain ? std::chars_format::fixed : std::chars_format::scientific);
  return {text.data(), end.ptr};
}

std::size_t edit_distance(const std::string& a, const std::string& b) {
  std::vector<std::size_t> row = identity_map<std::size_t>(b.size() + 1);
  for (std::size_t i = 1; i <= a.size(); ++i) {
    std::size_t diagonal = row[0];
    row[0] = i;
    for (std::size_t j = 1; j <= b.size(); ++j) {
      const std::size_t change = diagonal + (a[i - 1] == b[j - 1] ? 0 : 1);
      diagonal = row[j];
      row[j] = std::min({row[j] + 1, row[j - 1] + 1, change});
    }
  }
  return row.back();
}

std::string kind_of(const Value& value) {
  static constexpr std::array<const char*, 5> kinds = {"true or false", "an integer", "a number",
                                                       "a text", "a list of numbers"};
  return kinds[value.index()];
}

std::string wrong_type(const Value& value, const std::string& wanted) {
  return "is " + kind_of(value) + "; give " + wanted;
}

std::string number_objection(double x, const Range& range) {
  const bool endless = range.infinite && x == std::numeric_limits<double>::infinity();
  if (!std::isfinite(x) && !endless) return "is " + shortest(x) + "; give a finite number";
  if (range.holds(x)) return {};
  return "is " + shortest(x) + "; allowed is " + range.words();
}

std::string list_objection(const OptionInfo& option, const Value& value) {
  const auto* list = std::get_if<std::vector<double>>(&value);
  if (list == nullptr) return wrong_type(value, "a list of numbers");
  for (const double x : *list)
    if (std::string wrong = number_objection(x, option.range); !wrong.empty()) return wrong;
  if (option.type == OptionType::list || list->size() == 3) return {};
  return "has " + std::to_string(list->size()) + " numbers; give three, as in [0, 0, 1]";
}

std::string word_objection(const OptionInfo& option, const Value& value) {
  const auto* word = std::get_if<std::string>(&value);
  if (word == nullptr) return wrong_type(value, "a text in quotes");
  const std::vector<std::string>& known = option.choices;
  if (option.type == OptionType::text ||
      std::find(known.begin(), known.end(), *word) != known.end())
    return {};
  const std::string near = nearest_name(*word, known);
  return "is \"" + *word + "\"" + (near.empty() ? "" : "; did you mean \"" + near + "\"?") +
         "; allowed is one of " + joined(known);
}

}  // namespace

std::string in_words(const Value& value) {
  struct Writer {
    std::string operator()(bool b) const { return b ? "true" : "false"; }
    std::string operator()(std::int64_t i) const { return std::to_string(i); }
    std::string operator()(double x) const { return shortest(x); }
    std::string operator()(const std::string& text) const { return text; }
    std::string operator()(const std::vector<double>& list) const {
      std::string text;
      for (const double x : list) text += (text.empty() ? "" : ", ") + shortest(x);
      return "[" + text + "]";
    }
  };
  return std::visit(Writer{}, value);
}

Value times_power(Value value, int exponent) {
  if (auto* x = std::get_if<double>(&value)) *x = std::ldexp(*x, exponent);
  if (auto* list = std::get_if<std::vector<double>>(&value))
    for (double& x : *list) x = std::ldexp(x, exponent);
  return value;
}

std::string Range::words() const {
  if (std::isfinite(low) && std::isfinite(high))
    return (open ? "above " : "from ") + shortest(low) + (open ? ", at most " : " to ") +
           shortest(high);
  if (std::isfinite(low)) return (open ? "above " : "at least ") + shortest(low);
  return "any finite number";
}

std::string allowed(const OptionInfo& option) {
  switch (option.type) {
    case OptionType::flag:
      return "true or false";
    case OptionType::integer:
      return "an integer, " + option.range.words();
    case OptionType::number:
      return "a number, " + option.range.words();
    case OptionType::point:
      return "three numbers, as in [0, 0, 1]";
    case OptionType::list:
      return "a list of numbers";
    case OptionType::choice:
      return "one of " + joined(option.choices);
    case OptionType::text:
      break;
  }
  return "a text in quotes";
}

std::string objection(const OptionInfo& option, const Value& value) {
  const auto* integer = std::get_if<std::int64_t>(&value);
  switch (option.type) {
    case OptionType::flag:
      return std::holds_alternative<bool>(value) ? "" : wrong_type(value, allowed(option));
    case OptionType::integer:
      if (integer == nullptr) return wrong_type(value, allowed(option));
      return number_objection(static_cast<double>(*integer), option.range);
    case OptionType::number:
      if (integer != nullptr) return number_objection(static_cast<double>(*integer), option.range);
      if (const auto* x = std::get_if<double>(&value)) return number_objection(*x, option.range);
      return wrong_type(value, allowed(option));
    case OptionType::point:
    case OptionType::list:
      return list_objection(option, value);
    case OptionType::choice:
    case OptionType::text:
      break;
  }
  return word_objection(option, value);
}

std::string nearest_name(const std::string& wrong, const std::vector<std::string>& known) {
  std::string best;
  std::size_t least = std::max<std::size_t>(2, wrong.size() / 2) + 1;
  for (const std::string& name : known) {
    const std::size_t d = edit_distance(wrong, name);
    if (d < least) {
      least = d;
      best = name;
    }
  }
  return best;
}

std::string joined(const std::vector<std::string>& names) {
  std::string all;
  for (const std::string& name : names) all += (all.empty() ? "" : ", ") + name;
  return all;
}

}  // namespace suture
