// A row of a study's table: cells by the names of their columns, in order.
#include "sims/study/table/row.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>

#include "kernel/errors.h"

namespace suture::sims {
namespace {

template <class Entries>
auto find(Entries& entries, std::string_view column) {
  return std::find_if(entries.begin(), entries.end(),
                      [&](const Row::Entry& entry) { return entry.first == column; });
}

}  // namespace

std::string cell_text(const Cell& cell) {
  if (const auto* text = std::get_if<std::string>(&cell)) return *text;
  const double x = std::get<double>(cell);
  return std::isnan(x) ? "" : fmt::format("{:.9g}", x);
}

std::string Row::text(std::string_view column) const {
  const auto at = find(cells_, column);
  return at == cells_.end() ? "" : cell_text(at->second);
}

double Row::number(std::string_view column) const {
  const auto at = find(cells_, column);
  if (at == cells_.end())
    throw InternalFailure("study", fmt::format("its rows have no column \"{}\"", column));
  if (const auto* x = std::get_if<double>(&at->second)) return *x;
  const std::string& text = std::get<std::string>(at->second);
  return text.empty() ? kUnknown : std::strtod(text.c_str(), nullptr);
}

void Row::set(std::string_view column, Cell cell) {
  const auto at = find(cells_, column);
  if (at != cells_.end())
    at->second = std::move(cell);
  else
    cells_.emplace_back(column, std::move(cell));
}

void Row::append(const Row& more) {
  cells_.insert(cells_.end(), more.cells_.begin(), more.cells_.end());
}

}  // namespace suture::sims
