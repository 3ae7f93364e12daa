// A row of a study's table: cells by the names of their columns, in order.
#pragma once

#include <initializer_list>
#include <limits>
#include <string>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

namespace suture::sims {

inline constexpr double kUnknown = std::numeric_limits<double>::quiet_NaN();

/// A text or a number. An empty text and NaN are not known, or have no meaning for this row.
using Cell = std::variant<std::string, double>;

/// A cell as tables have it: numbers have nine digits, and NaN is empty.
std::string cell_text(const Cell& cell);

/// The words in which tables say how a run ended.
inline constexpr const char* kDoneRun = "done";        ///< to its end, every surgery committed
inline constexpr const char* kRefusedRun = "refused";  ///< to its end, but surgeries were refused
inline constexpr const char* kStoppedRun = "stopped";  ///< Suture said why it cannot go on
inline constexpr const char* kCrashedRun = "crashed";  ///< killed by a signal
inline constexpr const char* kTimedOutRun = "timed_out";

class Row {
 public:
  using Entry = std::pair<std::string, Cell>;
  Row() = default;
  Row(std::initializer_list<Entry> cells) : cells_(cells) {}

  const std::vector<Entry>& cells() const { return cells_; }

  /// The text in a column; empty if the row has no such column.
  std::string text(std::string_view column) const;

  /// The number in a column; NaN if it is not known.
  /// \throw InternalFailure if the row has no such column, which is misspelt then
  double number(std::string_view column) const;

  /// Gives a column's cell another value, or appends the column.
  void set(std::string_view column, Cell cell);

  /// Appends the cells of another row. \pre it shares no column with this one
  void append(const Row& more);

 private:
  std::vector<Entry> cells_;
};

}  // namespace suture::sims
