// Rows in a CSV file, and on their way from one process to another.
#include "sims/study/table/table.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/file.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "kernel/errors.h"
#include "kernel/files.h"

namespace suture::sims {
namespace {

using nlohmann::json;

/// A folder held by this process alone, among those that ask; no file is left by it.
class Held {
 public:
  explicit Held(const std::filesystem::path& folder)
      : file_(open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC)) {
    if (file_ < 0)
      throw InvalidInput(folder.string() + ": there is no such folder; make it, or give another");
    while (flock(file_, LOCK_EX) != 0 && errno == EINTR) {
    }
  }
  ~Held() { close(file_); }
  Held(const Held&) = delete;
  Held& operator=(const Held&) = delete;

 private:
  int file_;
};

void add_columns(Cells& columns, const Row& row) {
  std::size_t at = 0;
  for (const auto& [name, cell] : row.cells()) {
    const auto found = std::find(columns.begin(), columns.end(), name);
    if (found != columns.end()) {
      at = static_cast<std::size_t>(found - columns.begin()) + 1;
      continue;
    }
    columns.insert(columns.begin() + static_cast<std::ptrdiff_t>(at), name);
    ++at;
  }
}

json to_json(const Cell& cell) {
  const auto* x = std::get_if<double>(&cell);
  return x != nullptr && (std::isfinite(*x) || std::isnan(*x)) ? json(*x) : json(cell_text(cell));
}

Cell cell_from(const json& j) {
  if (j.is_string()) return j.get<std::string>();
  return j.is_null() ? kUnknown : j.get<double>();  // JSON has no NaN
}

}  // namespace

std::string to_csv(const std::vector<Row>& rows) {
  if (rows.empty()) return "";
  Cells columns;
  for (const Row& row : rows) add_columns(columns, row);
  std::string text = csv_line(columns);
  for (const Row& row : rows) {
    Cells cells;
    for (const std::string& column : columns) cells.push_back(row.text(column));
    text += csv_line(cells);
  }
  return text;
}

Table read_table(const std::filesystem::path& file) {
  Table table;
  if (!std::filesystem::exists(file)) return table;
  const std::vector<Cells> lines = csv_lines(read_file(file));
  if (!lines.empty()) table.columns = lines[0];
  for (std::size_t i = 1; i < lines.size(); ++i) {
    if (lines[i].size() != table.columns.size())
      throw InvalidInput(fmt::format("{}:{}: {} cells where the heading has {}; remove the row",
                                     file.string(), i + 1, lines[i].size(), table.columns.size()));
    Row& row = table.rows.emplace_back();
    for (std::size_t c = 0; c < lines[i].size(); ++c) row.append({{table.columns[c], lines[i][c]}});
  }
  return table;
}

void append_rows(const std::filesystem::path& file, const std::vector<Row>& rows,
                 const std::string& key) {
  const Held held(file.has_parent_path() ? file.parent_path() : ".");
  std::vector<Row> all = read_table(file).rows;
  std::erase_if(all, [&](const Row& old) {
    return std::any_of(rows.begin(), rows.end(),
                       [&](const Row& r) { return r.text(key) == old.text(key); });
  });
  all.insert(all.end(), rows.begin(), rows.end());
  write_file(file, to_csv(all));
}

std::string packed(const std::vector<Row>& rows) {
  json list = json::array();
  for (const Row& row : rows) {
    json& cells = list.emplace_back(json::array());
    for (const auto& [column, cell] : row.cells())
      cells.push_back(json::array({column, to_json(cell)}));
  }
  return list.dump(-1, ' ', true, json::error_handler_t::replace);
}

std::vector<Row> unpacked(const std::string& bytes) {
  std::vector<Row> rows;
  const json list = json::parse(bytes);
  for (const json& cells : list) {
    Row& row = rows.emplace_back();
    for (const json& cell : cells)
      row.append({{cell.at(0).get<std::string>(), cell_from(cell.at(1))}});
  }
  return rows;
}

}  // namespace suture::sims
