// Lines and numbers of text formats: no locale, no copies, and every line has its number.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "kernel/errors.h"

namespace suture {

/// The double nearest to a decimal number, "nan" and "inf" included; nothing if it is no number.
std::optional<double> parse_number(std::string_view token);
/// The integer that the token is; nothing if it is none of 64 bits.
std::optional<std::int64_t> parse_integer(std::string_view token);

/// Appends the shortest decimal number that reads back as the same bits; it has at most 17 digits.
void append_number(std::string& text, double x);
void append_integer(std::string& text, std::uint64_t x);

/// The token as a message may quote it: short, and printable.
std::string in_quotes(std::string_view token);

/// Walks over lines and the tokens in them. LF and CRLF both end a line; a comment runs from the
/// comment character to the end of its line; a backslash at the end joins two lines if asked to.
class TextLines {
 public:
  struct Syntax {
    char comment = '\0';  ///< '\0': the format has no comments
    bool continued = false;
  };
  TextLines(std::string_view bytes, std::string file, Syntax syntax)
      : rest_(bytes), file_(std::move(file)), syntax_(syntax) {
    if (rest_.starts_with("\xEF\xBB\xBF")) rest_.remove_prefix(3);
  }

  /// Moves to the next line that holds a token; false at the end of the file.
  bool next_line();
  /// The next token of this line; empty where the line has no more.
  std::string_view token();
  /// The next token of this line or, where it has no more, of the lines after it; empty at the end.
  std::string_view token_anywhere();

  /// The bytes not yet handed out as a line: after a text header a binary part starts there.
  std::string_view rest() const { return rest_; }
  std::size_t line() const { return line_; }
  const std::string& file() const { return file_; }

  /// The refusal "file:line: what; advice".
  InvalidInput refusal(const std::string& what, const std::string& advice) const;
  /// The next number or integer of this line, which messages call `of_what`. \throw InvalidInput if
  /// there is none
  double number(const char* of_what);
  std::int64_t integer(const char* of_what);

 private:
  bool take_line();

  std::string_view rest_, line_text_;
  std::string file_;
  Syntax syntax_;
  std::size_t line_ = 0;
};

}  // namespace suture
