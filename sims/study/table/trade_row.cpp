// The study's table as a CSV file, a row a run: written whole, read back to resume.
#include "sims/study/table/trade_row.h"

#include <fmt/format.h>

#include <cmath>
#include <cstdlib>

#include "kernel/errors.h"
#include "kernel/files.h"
#include "kernel/hash.h"
#include "sims/support/csv.h"

namespace suture::sims {
namespace {

Cells heading(const Row& row) {
  Cells cells = {"run", "design", "change"};
  for (const auto& [key, text] : row.settings) cells.push_back(key);
  for (const char* name : {"outcome", "failure"}) cells.emplace_back(name);
  for (const NamedFigure& f : kFigures) cells.emplace_back(f.name);
  for (const char* name : {"surface", "repeats", "study"}) cells.emplace_back(name);
  return cells;
}

Cells cells_of(const Row& row) {
  Cells cells = {std::to_string(row.run), row.design, row.change};
  for (const auto& [key, text] : row.settings) cells.push_back(text);
  cells.push_back(row.outcome);
  cells.push_back(row.failure);
  for (const NamedFigure& f : kFigures) {
    const double x = row.figures.*f.figure;
    cells.push_back(std::isnan(x) ? "" : fmt::format("{:.9g}", x));
  }
  cells.push_back(row.surface);
  cells.push_back(std::to_string(row.repeats));
  cells.push_back(row.study);
  return cells;
}

Row row_from(const Cells& head, const Cells& cells) {
  Row row;
  const std::size_t after = head.size() - kFigures.size() - 5;  // where the settings end
  const auto at = [&](std::size_t i) { return cells[i]; };
  row.run = std::atoi(at(0).c_str());
  row.design = at(1);
  row.change = at(2);
  for (std::size_t i = 3; i < after; ++i) row.settings.emplace_back(head[i], cells[i]);
  row.outcome = at(after);
  row.failure = at(after + 1);
  for (std::size_t i = 0; i < kFigures.size(); ++i) {
    const std::string& text = cells[after + 2 + i];
    if (!text.empty()) row.figures.*kFigures[i].figure = std::strtod(text.c_str(), nullptr);
  }
  const std::size_t end = after + 2 + kFigures.size();
  row.surface = at(end);
  row.repeats = std::atoi(at(end + 1).c_str());
  row.study = at(end + 2);
  return row;
}

}  // namespace

std::string to_csv(const std::vector<Row>& rows) {
  if (rows.empty()) return "";
  std::string out = csv_line(heading(rows.front()));
  for (const Row& row : rows) out += csv_line(cells_of(row));
  return out;
}

std::vector<Row> read_csv(const std::filesystem::path& file) {
  const std::vector<Cells> lines = csv_lines(read_file(file));
  std::vector<Row> rows;
  if (lines.empty()) return rows;
  Row like;
  const Cells& head = lines.front();
  const std::size_t fewest = heading(like).size();
  if (head.size() >= fewest)
    for (std::size_t i = 3; i + fewest - 3 < head.size(); ++i)
      like.settings.emplace_back(head[i], "");
  if (heading(like) != head)
    throw InvalidInput(file.string() +
                       ":1: these are not the columns of a study made by this version; give "
                       "another folder, or remove the file");
  for (std::size_t i = 1; i < lines.size(); ++i) {
    if (lines[i].size() != head.size())
      throw InvalidInput(fmt::format("{}:{}: {} cells where the heading has {}; remove the row",
                                     file.string(), i + 1, lines[i].size(), head.size()));
    rows.push_back(row_from(head, lines[i]));
  }
  return rows;
}

std::string fingerprint(std::string_view bytes) { return fmt::format("{:016x}", fnv1a(bytes)); }

std::string fingerprint(const Triangles& surface) {
  const auto bytes = [](const auto& list) {
    return std::string_view(reinterpret_cast<const char*>(list.data()),
                            list.size() * sizeof(list[0]));
  };
  return fingerprint(fingerprint(bytes(surface.positions)) + fingerprint(bytes(surface.triangles)));
}

}  // namespace suture::sims
