// Rows in a CSV file, and on their way from one process to another.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "sims/study/table/row.h"
#include "sims/support/csv.h"

namespace suture::sims {

struct Table {
  Cells columns;
  std::vector<Row> rows;  ///< each with all of the columns, as texts
};

/// CSV (RFC 4180) with a heading; empty for no rows. A column that only some rows have is in the
/// place that the first such row gives it, and empty in the others.
std::string to_csv(const std::vector<Row>& rows);

/// The table in a CSV file; an empty one if there is no file.
/// \throw InvalidInput with file and line if a line has another number of cells than the heading
Table read_table(const std::filesystem::path& file);

/// Adds rows to the file, which is written whole or not at all; several processes may do so at
/// once. Rows whose column `key` has the same text as a new one's are replaced.
/// \throw InvalidInput as read_table, and if the file cannot be written
void append_rows(const std::filesystem::path& file, const std::vector<Row>& rows,
                 const std::string& key);

/// Rows as bytes, in which numbers keep all of their bits, and back.
std::string packed(const std::vector<Row>& rows);
std::vector<Row> unpacked(const std::string& bytes);

}  // namespace suture::sims
