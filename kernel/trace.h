// Progress and timing that the library reports to whoever listens; nobody need listen.
#pragma once

#include <chrono>
#include <string_view>

namespace suture {

/// Hears of each stage as it ends. Functions take null where nobody listens.
class Trace {
 public:
  virtual ~Trace() = default;
  virtual void stage_ended(std::string_view stage, double seconds) = 0;
};

/// Measures seconds, which are only ever reported and never decide anything.
class Stopwatch {
 public:
  /// The seconds since the watch was made or lap() was last called.
  double lap() {
    const auto now = std::chrono::steady_clock::now();
    const double seconds = std::chrono::duration<double>(now - start_).count();
    start_ = now;
    return seconds;
  }

 private:
  std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
};

}  // namespace suture
