// CSV (RFC 4180): cells to lines and back.
#include "sims/support/csv.h"

namespace suture::sims {
namespace {

std::string quoted(const std::string& text) {
  if (text.find_first_of(",\"\n\r") == std::string::npos) return text;
  std::string out = "\"";
  for (const char c : text) out += c == '"' ? std::string("\"\"") : std::string(1, c);
  return out + "\"";
}

}  // namespace

std::string csv_line(const Cells& cells) {
  std::string out;
  for (std::size_t i = 0; i < cells.size(); ++i) out += (i == 0 ? "" : ",") + quoted(cells[i]);
  return out + "\n";
}

std::vector<Cells> csv_lines(const std::string& text) {
  std::vector<Cells> lines;
  Cells cells(1);
  bool inside = false;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const char c = text[i];
    if (inside && c == '"' && i + 1 < text.size() && text[i + 1] == '"') {
      cells.back() += text[++i];
    } else if (c == '"') {
      inside = !inside;
    } else if (!inside && c == ',') {
      cells.emplace_back();
    } else if (!inside && c == '\n') {
      lines.push_back(std::move(cells));
      cells = Cells(1);
    } else {
      cells.back() += c;
    }
  }
  if (cells.size() > 1 || !cells[0].empty()) lines.push_back(std::move(cells));
  return lines;
}

}  // namespace suture::sims
