// Numbers by from_chars and to_chars, which are exact and know no locale; lines by hand.
#include "kernel/formats/text.h"

#include <charconv>
#include <cmath>

namespace suture {

namespace {

constexpr bool blank(char c) {
  return c == ' ' || c == '\t' || c == '\r' || c == '\v' || c == '\f';
}

// from_chars takes no plus sign, which some programs write.
std::string_view without_plus(std::string_view token) {
  return token.size() > 1 && token[0] == '+' && token[1] != '-' ? token.substr(1) : token;
}

}  // namespace

std::optional<double> parse_number(std::string_view token) {
  token = without_plus(token);
  const char* const end = token.data() + token.size();
  double x = 0;
  const auto [stop, error] = std::from_chars(token.data(), end, x);
  if (stop != end || error == std::errc::invalid_argument) return {};
  if (error == std::errc{}) return x;
  long double wide = 0;  // beyond double: infinite, or so small that it rounds to zero
  if (std::from_chars(token.data(), end, wide).ec != std::errc{}) return {};
  return static_cast<double>(wide);
}

std::optional<std::int64_t> parse_integer(std::string_view token) {
  token = without_plus(token);
  std::int64_t i = 0;
  const auto [stop, error] = std::from_chars(token.data(), token.data() + token.size(), i);
  if (stop != token.data() + token.size() || error != std::errc{}) return {};
  return i;
}

void append_number(std::string& text, double x) {
  char digits[32];
  text.append(digits, std::to_chars(digits, digits + sizeof digits, x).ptr);
}

void append_integer(std::string& text, std::uint64_t x) {
  char digits[24];
  text.append(digits, std::to_chars(digits, digits + sizeof digits, x).ptr);
}

std::string in_quotes(std::string_view token) {
  constexpr std::size_t longest = 40;
  std::string out = "'";
  for (const char c : token.substr(0, longest)) out += c >= ' ' && c < 127 ? c : '?';
  return out + (token.size() > longest ? "…'" : "'");
}

bool TextLines::take_line() {
  if (rest_.empty()) return false;
  const std::size_t end = rest_.find('\n');
  line_text_ = rest_.substr(0, end);
  rest_.remove_prefix(end == std::string_view::npos ? rest_.size() : end + 1);
  ++line_;
  if (syntax_.comment != '\0') line_text_ = line_text_.substr(0, line_text_.find(syntax_.comment));
  return true;
}

bool TextLines::next_line() {
  while (take_line()) {
    while (!line_text_.empty() && blank(line_text_.front())) line_text_.remove_prefix(1);
    if (!line_text_.empty()) return true;
  }
  line_text_ = {};
  return false;
}

std::string_view TextLines::token() {
  while (!line_text_.empty() && blank(line_text_.front())) line_text_.remove_prefix(1);
  std::size_t end = 0;
  while (end < line_text_.size() && !blank(line_text_[end])) ++end;
  const std::string_view token = line_text_.substr(0, end);
  line_text_.remove_prefix(end);
  if (syntax_.continued && token == "\\" && take_line()) return this->token();
  return token;
}

std::string_view TextLines::token_anywhere() {
  for (;;) {
    const std::string_view next = token();
    if (!next.empty() || !next_line()) return next;
  }
}

InvalidInput TextLines::refusal(const std::string& what, const std::string& advice) const {
  return InvalidInput(file_ + ":" + std::to_string(line_) + ": " + what + "; " + advice);
}

double TextLines::number(const char* of_what) {
  const std::string_view next = token();
  if (const auto x = parse_number(next)) return *x;
  throw refusal(std::string(of_what) +
                    (next.empty() ? " is missing" : " is not a number: " + in_quotes(next)),
                "the file is damaged; export it again");
}

std::int64_t TextLines::integer(const char* of_what) {
  const std::string_view next = token();
  if (const auto i = parse_integer(next)) return *i;
  throw refusal(std::string(of_what) +
                    (next.empty() ? " is missing" : " is not a whole number: " + in_quotes(next)),
                "the file is damaged; export it again");
}

}  // namespace suture
