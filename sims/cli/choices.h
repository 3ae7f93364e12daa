// Flags that set options: what they take and their help come from the options' tables.
#pragma once

#include <CLI/CLI.hpp>
#include <array>
#include <string>
#include <vector>

#include "kernel/option_table.h"

namespace suture::sims {

/// Adds a flag for an option. What is given is checked as a file's value, and handed to `take`.
CLI::Option* add_option_flag(CLI::App& command, const std::string& flag, const OptionInfo& option,
                             const std::function<void(const Value&)>& take);

/// Adds flags for options of a table, each by the flag and the option's name; they set `options`.
template <class Options>
void add_option_flags(CLI::App& command, const OptionTable<Options>& table, Options& options,
                      const std::vector<std::pair<std::string, std::string>>& flags) {
  for (const auto& [flag, name] : flags) {
    const auto& row = table.row(name);
    add_option_flag(command, flag, row.about,
                    [&options, &row](const Value& value) { row.field.set(options, value); });
  }
}

/// Lets a flag take one of the names of an enumeration that is no option of a table.
template <class T, std::size_t N>
void add_choice(CLI::App& command, const std::string& flag, T& value,
                const std::array<Named<T>, N>& names, const std::string& help) {
  OptionInfo option{.meaning = help, .type = OptionType::choice};
  for (const Named<T>& named : names) option.choices.emplace_back(named.name);
  add_option_flag(command, flag, option, [&value, &names](const Value& word) {
    for (const Named<T>& named : names)
      if (std::get<std::string>(word) == named.name) value = named.value;
  });
}

}  // namespace suture::sims
