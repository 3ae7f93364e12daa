// The columns of a trade study's table, and what a row of it says.
#include "sims/study/table/trade_row.h"

#include <algorithm>
#include <cmath>

#include "kernel/errors.h"

namespace suture::sims {
namespace {

constexpr std::array<const char*, 3> kBefore = {"run", "design", "change"};  // the settings
constexpr std::array<const char*, 2> kEnding = {"outcome", "failure"};       // after them
constexpr std::array<const char*, 3> kLast = {"surface", "repeats", "study"};
constexpr std::size_t kAfter = kEnding.size() + kFigures.size() + kLast.size();

Cells columns_of(const Row& row) {
  Cells columns;
  for (const auto& [column, cell] : row.cells()) columns.push_back(column);
  return columns;
}

}  // namespace

Row trade_row(const SettingTexts& settings) {
  Row row;
  for (const char* column : kBefore) row.set(column, "");
  for (const auto& [key, text] : settings) row.set(key, text);
  for (const char* column : kEnding) row.set(column, "");
  for (const char* column : kFigures) row.set(column, kUnknown);
  for (const char* column : kLast) row.set(column, "");
  return row;
}

SettingTexts setting_texts(const Row& row) {
  SettingTexts settings;
  for (std::size_t i = kBefore.size(); i + kAfter < row.cells().size(); ++i)
    settings.emplace_back(row.cells()[i].first, cell_text(row.cells()[i].second));
  return settings;
}

std::vector<Row> read_trade_table(const std::filesystem::path& file) {
  Table table = read_table(file);
  SettingTexts settings;
  for (std::size_t i = kBefore.size(); i + kAfter < table.columns.size(); ++i)
    settings.emplace_back(table.columns[i], "");
  if (!table.columns.empty() && columns_of(trade_row(settings)) != table.columns)
    throw InvalidInput(file.string() +
                       ":1: these are not the columns of a study made by this version; give "
                       "another folder, or remove the file");
  return std::move(table.rows);
}

bool failed(const Row& row) { return row.text("outcome") != kDoneRun; }

bool sound(const Row& row) { return !failed(row) && row.number("topology_right") == 1; }

double mean_distance(const Row& row) {
  return (row.number("mean_distance_forth") + row.number("mean_distance_back")) / 2;
}

double max_distance(const Row& row) {
  const double forth = row.number("max_distance_forth"), back = row.number("max_distance_back");
  return forth > back ? forth : back;
}

double tracker_seconds(const Row& row) { return row.number("tracker_seconds"); }

double volume_error(const Row& row) { return std::abs(row.number("volume_error")); }

int run_number(const Row& row) { return static_cast<int>(row.number("run")); }

}  // namespace suture::sims
