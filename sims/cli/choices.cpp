// Flags that set options: what they take and their help come from the options' tables.
#include "sims/cli/choices.h"

namespace suture::sims {
namespace {

/// The words of a flag as a value of the option's type, or as a text where they are none.
Value value_of(const OptionInfo& option, const std::vector<std::string>& words) {
  std::vector<double> numbers;
  for (const std::string& word : words) {
    double x = 0;
    if (CLI::detail::lexical_cast(word, x)) numbers.push_back(x);
  }
  std::int64_t whole = 0;
  bool yes = false;
  switch (option.type) {
    case OptionType::flag:
      if (CLI::detail::lexical_cast(words.front(), yes)) return yes;
      break;
    case OptionType::integer:
      if (CLI::detail::lexical_cast(words.front(), whole)) return whole;
      break;
    case OptionType::number:
      if (numbers.size() == 1) return numbers.front();
      break;
    case OptionType::point:
    case OptionType::list:
      if (numbers.size() == words.size()) return numbers;
      break;
    case OptionType::choice:
    case OptionType::text:
      break;
  }
  return words.front();
}

std::string help_of(const OptionInfo& option) {
  std::string help = option.meaning;
  if (!help.empty()) help[0] = static_cast<char>(std::toupper(static_cast<unsigned char>(help[0])));
  std::string more;
  const auto add = [&more](const std::string& text) { more += (more.empty() ? "" : "; ") + text; };
  if (option.unit.words[0] != 0) add(std::string("in ") + option.unit.words);
  if (option.type == OptionType::choice) add("one of " + joined(option.choices));
  if (std::isfinite(option.range.low)) add(option.range.words());
  if (option.usual) add("default " + in_words(*option.usual));
  return more.empty() ? help : help + " (" + more + ")";
}

const char* type_name(OptionType type) {
  if (type == OptionType::choice) return "WORD";
  return type == OptionType::integer ? "N" : "X";
}

}  // namespace

CLI::Option* add_option_flag(CLI::App& command, const std::string& flag, const OptionInfo& option,
                             const std::function<void(const Value&)>& take) {
  const auto set = [flag, option, take](const std::vector<std::string>& words) {
    const Value value = value_of(option, words);
    const std::string wrong = objection(option, value);
    if (!wrong.empty()) throw CLI::ValidationError(flag, wrong);
    take(value);
  };
  return command.add_option_function<std::vector<std::string>>(flag, set, help_of(option))
      ->expected(option.type == OptionType::point ? 3 : 1)
      ->type_name(type_name(option.type));
}

}  // namespace suture::sims
