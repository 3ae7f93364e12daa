// A row of the table of measurements: cells by name, in order; and the table in its file.
#pragma once

#include <filesystem>
#include <string>
#include <utility>
#include <vector>

namespace suture::sims {

/// Column and text. An empty text: not known, or of no meaning for this method.
using Record = std::vector<std::pair<std::string, std::string>>;

/// A number to nine digits; empty for NaN.
std::string cell_of(double x);

/// The text in a column, or empty.
std::string text_in(const Record& record, const std::string& column);

/// All rows of a CSV file, each with all of its columns; none if there is no file.
/// \throw InvalidInput with file and line if a line has another number of cells than the heading
std::vector<Record> read_records(const std::filesystem::path& file);

/// Adds rows to the file, which is written whole or not at all; several processes may do so at
/// once. Columns that only some rows have are added to all, in the place that the first such row
/// gives. Rows whose column `key` has the same text as a new one's are replaced. \throw
/// InvalidInput as read_records, and if the file cannot be written
void append_records(const std::filesystem::path& file, const std::vector<Record>& rows,
                    const std::string& key);

}  // namespace suture::sims
