// Options that take one of the words of an enumeration.
#pragma once

#include <CLI/CLI.hpp>
#include <algorithm>
#include <array>
#include <string>
#include <vector>

#include "sims/support/keys.h"

namespace suture::sims {

/// Lets an option take one of the names of an enumeration.
template <class T, std::size_t N>
void add_choice(CLI::App& command, const std::string& flag, T& value,
                const std::array<Named<T>, N>& names, const std::string& help) {
  std::vector<std::string> words;
  for (const Named<T>& named : names) words.emplace_back(named.name);
  const auto choose = [&value, &names](const std::string& word) {
    for (const Named<T>& named : names)
      if (word == named.name) value = named.value;
  };
  const auto allowed = [words](const std::string& word) {
    if (std::find(words.begin(), words.end(), word) != words.end()) return std::string();
    return "\"" + word + "\" is not known; give one of " + joined(words);
  };
  command.add_option_function<std::string>(flag, choose, help)->check(allowed)->type_name("WORD");
}

}  // namespace suture::sims
