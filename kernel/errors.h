// What Suture throws: bad input, and a broken invariant of our own.
#pragma once

#include <cstdio>
#include <stdexcept>
#include <string>
#include <utility>

namespace suture {

/// A number as messages show it, at any size: std::to_string gives 0.000000 for all small ones.
inline std::string number(double x, const char* format = "%.6g") {
  char text[32];
  std::snprintf(text, sizeof text, format, x);
  return text;
}

/// Input that cannot be used. The message says what is wrong, where, and what to do. Exit code 2.
class InvalidInput : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// An invariant of Suture broke in `stage`; the mesh is the one before. Exit code 3.
class InternalFailure : public std::runtime_error {
 public:
  InternalFailure(std::string stage, const std::string& what)
      : std::runtime_error(stage + ": " + what), stage_(std::move(stage)) {}
  const std::string& stage() const { return stage_; }

 private:
  std::string stage_;
};

}  // namespace suture
