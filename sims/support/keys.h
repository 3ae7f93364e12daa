// A table of named values in which every key is checked: its type, its range, and its name.
#pragma once

#include <map>
#include <set>

#include "kernel/option_table.h"

namespace suture::sims {

/// A value as a scene file has it, but words without quotes and lists without commas; numbers round
/// trip.
std::string text_of(const Value& value);

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

  /// The value of an option; nothing where the table has none and the option can do without.
  std::optional<Value> value(const OptionInfo& option);

  double number(const std::string& key, Range allowed);
  double number(const std::string& key, Range allowed, double fallback);
  std::int64_t integer(const std::string& key, Range allowed, std::int64_t fallback);
  std::string text(const std::string& key);
  std::string text(const std::string& key, const std::string& fallback);
  std::vector<double> list(const std::string& key, Range allowed);

  template <class T, std::size_t N>
  T choice(const std::string& key, const std::array<Named<T>, N>& allowed, T fallback) {
    if (!has(key)) return asked_.insert(key), fallback;
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
  std::map<std::string, Entry> entries_;
  std::string name_, where_;
  std::set<std::string> asked_;
};

/// Reads every option of a table; those that the keys do not have stay as they are in `options`.
/// \throw InvalidInput as the getters of Keys
template <class Options>
void read(Keys& keys, const OptionTable<Options>& table, Options& options) {
  for (const auto& row : table.rows())
    if (const std::optional<Value> value = keys.value(row.about)) row.field.set(options, *value);
}

}  // namespace suture::sims
