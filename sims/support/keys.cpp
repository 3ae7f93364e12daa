// A table of named values in which every key is checked: its type, its range, and its name.
#include "sims/support/keys.h"

#include <fmt/format.h>

#include "kernel/errors.h"

namespace suture::sims {

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

void Keys::refuse(const std::string& key, const std::string& what) const {
  const auto at = entries_.find(key);
  const std::string& place = at == entries_.end() ? where_ : at->second.where;
  throw InvalidInput(
      fmt::format("{}: {}{}{}: {}", place, name_, name_.empty() ? "" : ".", key, what));
}

std::optional<Value> Keys::value(const OptionInfo& option) {
  asked_.insert(option.name);
  const auto at = entries_.find(option.name);
  if (at == entries_.end()) {
    if (option.required) refuse(option.name, "is missing; give " + allowed(option));
    return std::nullopt;
  }
  const std::string wrong = objection(option, at->second.value);
  if (!wrong.empty()) refuse(option.name, wrong);
  return at->second.value;
}

double Keys::number(const std::string& key, Range allowed) {
  const OptionInfo option{
      .name = key, .range = allowed, .required = true, .type = OptionType::number};
  return option_values::number_in(*value(option));
}

double Keys::number(const std::string& key, Range allowed, double fallback) {
  const auto given = value({.name = key, .range = allowed, .type = OptionType::number});
  return given ? option_values::number_in(*given) : fallback;
}

std::int64_t Keys::integer(const std::string& key, Range allowed, std::int64_t fallback) {
  const auto given = value({.name = key, .range = allowed, .type = OptionType::integer});
  return given ? std::get<std::int64_t>(*given) : fallback;
}

std::string Keys::text(const std::string& key) {
  return std::get<std::string>(*value({.name = key, .required = true, .type = OptionType::text}));
}

std::string Keys::text(const std::string& key, const std::string& fallback) {
  const auto given = value({.name = key, .type = OptionType::text});
  return given ? std::get<std::string>(*given) : fallback;
}

std::string Keys::one_of(const std::string& key, const std::vector<std::string>& names) {
  OptionInfo option{.name = key, .required = true, .type = OptionType::choice};
  option.choices = names;
  return std::get<std::string>(*value(option));
}

std::vector<double> Keys::list(const std::string& key, Range allowed) {
  const auto given = value({.name = key, .range = allowed, .type = OptionType::list});
  return given ? std::get<std::vector<double>>(*given) : std::vector<double>{};
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
