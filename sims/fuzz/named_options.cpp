// An option's full name begins with the name of its table.
#include "sims/fuzz/named_options.h"

#include <optional>

#include "surgery/model/option_table.h"

namespace suture::sims {

namespace {

/// The option's name inside the table, if it stands there.
template <class Table>
std::optional<std::string> key_in(const Table& table, const std::string& name) {
  const std::string start = table.name() + ".";
  if (name.rfind(start, 0) != 0) return std::nullopt;
  return name.substr(start.size());
}

[[noreturn]] void refuse(const std::string& name) {
  throw InvalidInput("there is no option \"" + name + "\"; there are " + joined(option_names()));
}

}  // namespace

std::vector<std::string> option_names() {
  std::vector<std::string> names;
  const auto add = [&](const auto& table) {
    for (const auto& row : table.rows()) names.push_back(table.name() + "." + row.name);
  };
  add(tracker_options());
  add(quality_options());
  return names;
}

const OptionInfo& option_named(const std::string& name) {
  if (const auto key = key_in(tracker_options(), name)) return tracker_options().row(*key).about;
  if (const auto key = key_in(quality_options(), name)) return quality_options().row(*key).about;
  refuse(name);
}

void set_option(TrackerOptions& options, const std::string& name, const Value& value) {
  if (const auto key = key_in(tracker_options(), name))
    return set(options, tracker_options(), *key, value);
  if (const auto key = key_in(quality_options(), name))
    return set(options.quality, quality_options(), *key, value);
  refuse(name);
}

std::vector<std::pair<std::string, Value>> named_values(const TrackerOptions& options) {
  std::vector<std::pair<std::string, Value>> all;
  const auto add = [&](const auto& some, const auto& table) {
    for (const auto& [key, value] : values(some, table))
      all.emplace_back(table.name() + "." + key, value);
  };
  add(options, tracker_options());
  add(options.quality, quality_options());
  return all;
}

void scale_lengths(TrackerOptions& options, int exponent) {
  suture::scale_lengths(options, tracker_options(), exponent);
  suture::scale_lengths(options.quality, quality_options(), exponent);
}

}  // namespace suture::sims
