// A row of the table of measurements: cells by name, in order; and the table in its file.
#include "sims/study/table/table.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/file.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>

#include "kernel/errors.h"
#include "kernel/files.h"
#include "sims/support/csv.h"

namespace suture::sims {
namespace {

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

void add_columns(Cells& columns, const Record& row) {
  std::size_t at = 0;
  for (const auto& [name, text] : row) {
    const auto found = std::find(columns.begin(), columns.end(), name);
    if (found != columns.end()) {
      at = static_cast<std::size_t>(found - columns.begin()) + 1;
      continue;
    }
    columns.insert(columns.begin() + static_cast<std::ptrdiff_t>(at), name);
    ++at;
  }
}

std::string csv_of(const std::vector<Record>& rows) {
  Cells columns;
  for (const Record& row : rows) add_columns(columns, row);
  std::string text = csv_line(columns);
  for (const Record& row : rows) {
    Cells cells;
    for (const std::string& column : columns) cells.push_back(text_in(row, column));
    text += csv_line(cells);
  }
  return text;
}

}  // namespace

std::string cell_of(double x) { return std::isnan(x) ? "" : fmt::format("{:.9g}", x); }

std::string text_in(const Record& record, const std::string& column) {
  for (const auto& [name, text] : record)
    if (name == column) return text;
  return "";
}

std::vector<Record> read_records(const std::filesystem::path& file) {
  std::vector<Record> rows;
  if (!std::filesystem::exists(file)) return rows;
  const std::vector<Cells> lines = csv_lines(read_file(file));
  for (std::size_t i = 1; i < lines.size(); ++i) {
    if (lines[i].size() != lines[0].size())
      throw InvalidInput(fmt::format("{}:{}: {} cells where the heading has {}; remove the row",
                                     file.string(), i + 1, lines[i].size(), lines[0].size()));
    Record& row = rows.emplace_back();
    for (std::size_t c = 0; c < lines[i].size(); ++c) row.emplace_back(lines[0][c], lines[i][c]);
  }
  return rows;
}

void append_records(const std::filesystem::path& file, const std::vector<Record>& rows,
                    const std::string& key) {
  const Held held(file.has_parent_path() ? file.parent_path() : ".");
  std::vector<Record> all = read_records(file);
  const auto remade = [&](const Record& old) {
    return std::any_of(rows.begin(), rows.end(),
                       [&](const Record& r) { return text_in(r, key) == text_in(old, key); });
  };
  all.erase(std::remove_if(all.begin(), all.end(), remade), all.end());
  all.insert(all.end(), rows.begin(), rows.end());
  write_file(file, csv_of(all));
}

}  // namespace suture::sims
