// The two exceptions of Suture: one for bad input, one for a broken invariant of our own.
#pragma once

#include <cstdio>
#include <stdexcept>
#include <string>
#include <utility>

namespace suture {

/// The number as messages show it, by a format of printf for one double. std::to_string would give
/// 0.000000 for every small number.
inline std::string number(double x, const char* format = "%.6g") {
  char text[32];
  std::snprintf(text, sizeof text, format, x);
  return text;
}

/// Thrown for input that cannot be used. The message says what is wrong, where, and what to do; the
/// program then ends with exit code 2.
class InvalidInput : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// Thrown where an invariant of Suture broke in `stage`. The mesh is the one before; the program
/// then ends with exit code 3.
class InternalFailure : public std::runtime_error {
 public:
  InternalFailure(std::string stage, const std::string& what)
      : std::runtime_error(stage + ": " + what), stage_(std::move(stage)) {}
  const std::string& stage() const { return stage_; }

 private:
  std::string stage_;
};

}  // namespace suture
