// A table of named values in which every key is checked: its type, its range, and its name.
#pragma once

#include <array>
#include <cstdint>
#include <limits>
#include <map>
#include <set>
#include <string>
#include <variant>
#include <vector>

#include "kernel/triangles.h"

namespace suture::sims {

/// What a key may hold; numbers in lists are doubles.
using Value = std::variant<bool, std::int64_t, double, std::string, std::vector<double>>;

/// A value as a scene file has it, but words without quotes and lists without commas; numbers round
/// trip.
std::string text_of(const Value& value);

/// The numbers that a key allows, in its own unit.
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

/// The name among `known` that is nearest to `wrong` by edit distance, or empty if none is near.
std::string nearest_name(const std::string& wrong, const std::vector<std::string>& known);

/// Names joined for a message: "a, b, c".
std::string joined(const std::vector<std::string>& names);

/// Reads a table key by key. Each getter throws InvalidInput with the place, the key and what is
/// allowed where the value has the wrong type or is out of range; numbers must be finite. `done`
/// throws for a key that no getter asked for, and suggests the nearest that one did.
class Keys {
 public:
  struct Entry {
    Value value;
    std::string where;  ///< "file:line"
  };

  /// `name` is the table's own name, as in "tracker"; `where` its place.
  Keys(std::map<std::string, Entry> entries, std::string name, std::string where)
      : entries_(std::move(entries)), name_(std::move(name)), where_(std::move(where)) {}

  /// Gives `key` another value, or adds it; `where` is its place in messages.
  void put(const std::string& key, Value value, const std::string& where) {
    entries_.insert_or_assign(key, Entry{std::move(value), where});
  }

  bool has(const std::string& key) const { return entries_.count(key) != 0; }
  std::vector<std::string> names() const;       ///< of the keys given, in alphabetical order
  std::map<std::string, Value> values() const;  ///< all that was given, unchecked

  double number(const std::string& key, Range allowed);
  double number(const std::string& key, Range allowed, double fallback);
  std::int64_t integer(const std::string& key, Range allowed, std::int64_t fallback);
  bool flag(const std::string& key, bool fallback);
  std::string text(const std::string& key);
  std::string text(const std::string& key, const std::string& fallback);
  Point vector(const std::string& key, const Point& fallback);
  std::vector<double> list(const std::string& key, Range allowed);

  template <class T, std::size_t N>
  T choice(const std::string& key, const std::array<Named<T>, N>& allowed, T fallback) {
    if (!ask(key)) return fallback;
    std::vector<std::string> names;
    for (const Named<T>& a : allowed) names.push_back(a.name);
    const std::string given = one_of(key, names);
    for (const Named<T>& a : allowed)
      if (given == a.name) return a.value;
    return fallback;
  }
  /// The text of `key`, which must be one of `names`.
  std::string one_of(const std::string& key, const std::vector<std::string>& names);

  /// \throw InvalidInput if a key is left that no getter asked for
  void done() const;

  /// \throw InvalidInput always: "file:line: table.key: what"
  [[noreturn]] void refuse(const std::string& key, const std::string& what) const;

 private:
  const Entry* ask(const std::string& key);
  const Entry& require(const std::string& key, const std::string& kind);
  double checked(const std::string& key, double x, const Range& allowed) const;

  std::map<std::string, Entry> entries_;
  std::string name_, where_;
  std::set<std::string> asked_;
};

}  // namespace suture::sims
