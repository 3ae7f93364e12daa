// A table of named values in which every key is checked: its type, its range, and its name.
#include "sims/support/keys.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "kernel/errors.h"
#include "kernel/lists.h"

namespace suture::sims {
namespace {

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

}  // namespace

std::string text_of(const Value& value) {
  if (const auto* list = std::get_if<std::vector<double>>(&value))
    return fmt::format("{}", fmt::join(*list, " "));
  return std::visit(
      [](const auto& v) -> std::string {
        using T = std::decay_t<decltype(v)>;
        if constexpr (std::is_same_v<T, std::vector<double>>)
          return {};
        else
          return fmt::format("{}", v);
      },
      value);
}

std::string Range::words() const {
  if (std::isfinite(low) && std::isfinite(high)) return fmt::format("from {} to {}", low, high);
  if (std::isfinite(low)) return fmt::format("{} {}", open ? "above" : "at least", low);
  return "any finite number";
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

std::map<std::string, Value> Keys::values() const {
  std::map<std::string, Value> result;
  for (const auto& [key, entry] : entries_) result[key] = entry.value;
  return result;
}

std::vector<std::string> Keys::names() const {
  std::vector<std::string> names;
  for (const auto& [key, entry] : entries_) names.push_back(key);
  return names;
}

const Keys::Entry* Keys::ask(const std::string& key) {
  asked_.insert(key);
  const auto at = entries_.find(key);
  return at == entries_.end() ? nullptr : &at->second;
}

const Keys::Entry& Keys::require(const std::string& key, const std::string& kind) {
  const Entry* entry = ask(key);
  if (entry == nullptr) refuse(key, "is missing; give " + kind);
  return *entry;
}

void Keys::refuse(const std::string& key, const std::string& what) const {
  const auto at = entries_.find(key);
  const std::string& place = at == entries_.end() ? where_ : at->second.where;
  throw InvalidInput(
      fmt::format("{}: {}{}{}: {}", place, name_, name_.empty() ? "" : ".", key, what));
}

double Keys::checked(const std::string& key, double x, const Range& allowed) const {
  const bool endless = allowed.infinite && x == std::numeric_limits<double>::infinity();
  if (!std::isfinite(x) && !endless) refuse(key, fmt::format("is {}; give a finite number", x));
  if (!allowed.holds(x)) refuse(key, fmt::format("is {}; allowed is {}", x, allowed.words()));
  return x;
}

double Keys::number(const std::string& key, Range allowed) {
  const Value& value = require(key, "a number, " + allowed.words()).value;
  if (const auto* i = std::get_if<std::int64_t>(&value))
    return checked(key, static_cast<double>(*i), allowed);
  if (const auto* d = std::get_if<double>(&value)) return checked(key, *d, allowed);
  refuse(key, "is " + kind_of(value) + "; give a number, " + allowed.words());
}

double Keys::number(const std::string& key, Range allowed, double fallback) {
  return ask(key) == nullptr ? fallback : number(key, allowed);
}

std::int64_t Keys::integer(const std::string& key, Range allowed, std::int64_t fallback) {
  const Entry* entry = ask(key);
  if (entry == nullptr) return fallback;
  const auto* i = std::get_if<std::int64_t>(&entry->value);
  if (i == nullptr)
    refuse(key, "is " + kind_of(entry->value) + "; give an integer, " + allowed.words());
  checked(key, static_cast<double>(*i), allowed);
  return *i;
}

bool Keys::flag(const std::string& key, bool fallback) {
  const Entry* entry = ask(key);
  if (entry == nullptr) return fallback;
  const auto* b = std::get_if<bool>(&entry->value);
  if (b == nullptr) refuse(key, "is " + kind_of(entry->value) + "; give true or false");
  return *b;
}

std::string Keys::text(const std::string& key) {
  const Value& value = require(key, "a text in quotes").value;
  const auto* s = std::get_if<std::string>(&value);
  if (s == nullptr) refuse(key, "is " + kind_of(value) + "; give a text in quotes");
  return *s;
}

std::string Keys::text(const std::string& key, const std::string& fallback) {
  return ask(key) == nullptr ? fallback : text(key);
}

std::string Keys::one_of(const std::string& key, const std::vector<std::string>& names) {
  require(key, "one of " + joined(names));
  const std::string given = text(key);
  if (std::find(names.begin(), names.end(), given) != names.end()) return given;
  const std::string near = nearest_name(given, names);
  refuse(key, fmt::format("is \"{}\"{}; allowed is one of {}", given,
                          near.empty() ? "" : "; did you mean \"" + near + "\"?", joined(names)));
}

std::vector<double> Keys::list(const std::string& key, Range allowed) {
  const Entry* entry = ask(key);
  if (entry == nullptr) return {};
  const auto* v = std::get_if<std::vector<double>>(&entry->value);
  if (v == nullptr) refuse(key, "is " + kind_of(entry->value) + "; give a list of numbers");
  for (const double x : *v) checked(key, x, allowed);
  return *v;
}

Point Keys::vector(const std::string& key, const Point& fallback) {
  if (ask(key) == nullptr) return fallback;
  const std::vector<double> v = list(key, Range::any());
  if (v.size() != 3)
    refuse(key, fmt::format("has {} numbers; give three, as in [0, 0, 1]", v.size()));
  return {v[0], v[1], v[2]};
}

void Keys::done() const {
  const std::vector<std::string> known(asked_.begin(), asked_.end());
  for (const auto& [key, entry] : entries_) {
    if (asked_.count(key) != 0) continue;
    const std::string near = nearest_name(key, known);
    refuse(key, fmt::format("is not a known key{}; allowed here: {}",
                            near.empty() ? "" : "; did you mean \"" + near + "\"?", joined(known)));
  }
}

}  // namespace suture::sims
