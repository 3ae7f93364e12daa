// A TOML file as tables of checked keys, each with the line it stands on.
#pragma once

#include <filesystem>
#include <optional>
#include <vector>

#include "sims/support/keys.h"

namespace suture::sims {

/// A table's own values, and the tables inside it by name.
struct TomlTable {
  Keys keys;
  std::map<std::string, TomlTable> tables;
  std::map<std::string, std::vector<TomlTable>> lists;  ///< arrays of tables
  std::map<std::string, std::string> places;            ///< "file:line" of each inner table
  std::string where;

  /// \throw InvalidInput if there is an inner table that is not among `known`
  void allow_tables(const std::vector<std::string>& known) const;
};

/// `file` is the name for messages. \throw InvalidInput if the text is not TOML, with the line
TomlTable parse_toml(const std::string& text, const std::filesystem::path& file);

/// A value as a TOML file has it, which reads back to the same bits.
std::string toml_of(const Value& value);

}  // namespace suture::sims
