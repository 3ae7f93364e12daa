// A TOML file as tables of checked keys, each with the line it stands on.
#include "sims/scene/toml_keys.h"

#include <fmt/format.h>
#include <toml++/toml.h>

#include <algorithm>

#include "kernel/errors.h"

namespace suture::sims {
namespace {

// Scenes have names of three parts, and tables in lists of tables. Without bounds one name of some
// 100,000 parts takes the stack: toml++ 3.3 bounds how deep values are nested, but not names.
constexpr int kMostParts = 16, kDeepest = 16;

/// Finds the end of the text in quotes that starts at `begin`: one line, or more between three
/// quotes.
std::size_t end_of_quoted(std::string_view text, std::size_t begin) {
  const char quote = text[begin];
  const bool lines = text.substr(begin, 3) == std::string(3, quote);
  for (std::size_t i = begin + (lines ? 3 : 1); i < text.size(); ++i) {
    if (text[i] == '\\' && quote == '"')
      ++i;
    else if (lines ? text.substr(i, 3) == std::string(3, quote) : text[i] == quote)
      return i + (lines ? 3 : 1);
    else if (!lines && text[i] == '\n')
      return i;
  }
  return text.size();
}

/// \throw InvalidInput if a name such as a.b.c has more than kMostParts parts
void require_short_names(std::string_view text, const std::string& file) {
  int dots = 0;
  for (std::size_t i = 0; i < text.size(); ++i) {
    if (text[i] == '#') i = std::min(text.find('\n', i), text.size() - 1);
    if (text[i] == '"' || text[i] == '\'') i = end_of_quoted(text, i) - 1;
    if (std::string_view("\n=,[]{}").find(text[i]) != std::string_view::npos) dots = 0;
    if (text[i] == '.' && ++dots >= kMostParts)
      throw InvalidInput(fmt::format("{}:{}: a name has more than {} parts; no scene needs such",
                                     file, 1 + std::count(text.begin(), text.begin() + i, '\n'),
                                     kMostParts));
  }
}

/// Turns one parsed TOML table, and all in it, into ours.
class Converter {
 public:
  explicit Converter(std::string file) : file_(std::move(file)) {}

  TomlTable table(const toml::table& from, const std::string& name, int depth = 0) const {
    if (depth > kDeepest)
      throw InvalidInput(fmt::format("{}: tables are nested more than {} deep; no scene needs such",
                                     place(from), kDeepest));
    std::map<std::string, Keys::Entry> entries;
    TomlTable result{Keys({}, name, place(from)), {}, {}, {}, place(from)};
    for (const auto& [key, node] : from) {
      const std::string k(key.str());
      const std::string full = name.empty() ? k : name + "." + k;
      if (const toml::table* inner = node.as_table()) {
        result.tables.emplace(k, table(*inner, full, depth + 1));
        result.places.emplace(k, place(node));
      } else if (node.is_array_of_tables()) {
        for (const toml::node& item : *node.as_array()) {
          auto& list = result.lists[k];
          list.push_back(
              table(*item.as_table(), fmt::format("{}[{}]", full, list.size()), depth + 1));
        }
        result.places.emplace(k, place(node));
      } else {
        entries.emplace(k, Keys::Entry{value(node, full), place(node)});
      }
    }
    result.keys = Keys(std::move(entries), name, result.where);
    return result;
  }

 private:
  std::string place(const toml::node& node) const {
    return fmt::format("{}:{}", file_, std::max<std::size_t>(1, node.source().begin.line));
  }

  Value value(const toml::node& node, const std::string& name) const {
    if (const auto* b = node.as_boolean()) return b->get();
    if (const auto* i = node.as_integer()) return i->get();
    if (const auto* d = node.as_floating_point()) return d->get();
    if (const auto* s = node.as_string()) return s->get();
    if (const auto* array = node.as_array()) {
      std::vector<double> list;
      for (const toml::node& item : *array) {
        const auto x = item.value<double>();
        if (!item.is_number() || !x)
          throw InvalidInput(
              fmt::format("{}: {}: a list here may hold numbers only", place(item), name));
        list.push_back(*x);
      }
      return list;
    }
    throw InvalidInput(fmt::format("{}: {}: dates and times have no use here", place(node), name));
  }

  std::string file_;
};

}  // namespace

void TomlTable::allow_tables(const std::vector<std::string>& known) const {
  for (const auto& [name, at] : places) {
    if (std::find(known.begin(), known.end(), name) != known.end()) continue;
    const std::string near = nearest_name(name, known);
    throw InvalidInput(fmt::format("{}: [{}] is not a known table{}; allowed here: {}", at, name,
                                   near.empty() ? "" : "; did you mean [" + near + "]?",
                                   known.empty() ? "none" : joined(known)));
  }
}

TomlTable parse_toml(const std::string& text, const std::filesystem::path& file) {
  require_short_names(text, file.string());
  try {
    const toml::table parsed = toml::parse(text, file.string());
    return Converter(file.string()).table(parsed, "");
  } catch (const toml::parse_error& error) {
    throw InvalidInput(
        fmt::format("{}:{}: {}", file.string(), error.source().begin.line, error.description()));
  }
}

namespace {

/// Always a float to TOML, the sign of zero kept.
std::string number_text(double x) {
  std::string text = in_words(x);
  if (text.find_first_of(".en") == std::string::npos) text += ".0";
  return text;
}

std::string quoted(const std::string& text) {
  static constexpr std::string_view special = "\"\\\b\f\n\r\t", letters = "\"\\bfnrt";
  std::string all = "\"";
  for (const char c : text) {
    if (const std::size_t at = special.find(c); at != std::string_view::npos)
      all += {'\\', letters[at]};
    else if (static_cast<unsigned char>(c) < 0x20)
      all += fmt::format("\\u{:04x}", static_cast<int>(c));
    else
      all += c;
  }
  return all + "\"";
}

}  // namespace

std::string toml_of(const Value& value) {
  if (const auto* x = std::get_if<double>(&value)) return number_text(*x);
  if (const auto* text = std::get_if<std::string>(&value)) return quoted(*text);
  const auto* list = std::get_if<std::vector<double>>(&value);
  if (list == nullptr) return in_words(value);
  std::string all;
  for (const double x : *list) all += (all.empty() ? "" : ", ") + number_text(x);
  return "[" + all + "]";
}

}  // namespace suture::sims
