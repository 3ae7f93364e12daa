// A TOML file as tables of checked keys, each with the line it stands on.
#include "sims/toml_keys.h"

#include <fmt/format.h>
#include <toml++/toml.h>

#include "kernel/errors.h"

namespace suture {
namespace {

/// Turns one parsed TOML table, and all in it, into ours.
class Converter {
 public:
  explicit Converter(std::string file) : file_(std::move(file)) {}

  TomlTable table(const toml::table& from, const std::string& name) const {
    std::map<std::string, Keys::Entry> entries;
    TomlTable result{Keys({}, name, place(from)), {}, {}, {}, place(from)};
    for (const auto& [key, node] : from) {
      const std::string k(key.str());
      const std::string full = name.empty() ? k : name + "." + k;
      if (const toml::table* inner = node.as_table()) {
        result.tables.emplace(k, table(*inner, full));
        result.places.emplace(k, place(node));
      } else if (node.is_array_of_tables()) {
        for (const toml::node& item : *node.as_array()) {
          auto& list = result.lists[k];
          list.push_back(table(*item.as_table(), fmt::format("{}[{}]", full, list.size())));
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
  try {
    const toml::table parsed = toml::parse(text, file.string());
    return Converter(file.string()).table(parsed, "");
  } catch (const toml::parse_error& error) {
    throw InvalidInput(
        fmt::format("{}:{}: {}", file.string(), error.source().begin.line, error.description()));
  }
}

}  // namespace suture
