// CSV (RFC 4180): cells to lines and back.
#pragma once

#include <string>
#include <vector>

namespace suture::sims {

using Cells = std::vector<std::string>;

/// A line with its end; cells that need it are put in quotes.
std::string csv_line(const Cells& cells);

/// The cells of each line; a cell in quotes may hold commas, line ends and doubled quotes.
std::vector<Cells> csv_lines(const std::string& text);

}  // namespace suture::sims
