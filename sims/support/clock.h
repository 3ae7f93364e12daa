// What this process has used: seconds by the clock, seconds of its cores, and memory.
#pragma once

#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace suture::sims {

/// Seconds by the clock since a moment that is the same for the whole process.
double wall_seconds();

/// CPU seconds of this process, of all its threads, since it began.
double process_seconds();

/// The most memory that this process has held so far, in MB (10⁶ bytes).
double peak_megabytes();

/// Lets peak_megabytes start from what is held now, where the system can.
void forget_peak();

/// A clock that is read in laps.
class Lap {
 public:
  using Clock = double (*)();
  explicit Lap(Clock clock = process_seconds) : clock_(clock), start_(clock()) {}

  /// Seconds since the lap began.
  double seconds() const { return clock_() - start_; }

  /// Ends the lap and begins the next. \return the seconds of the one that ended
  double next() {
    const double now = clock_();
    return now - std::exchange(start_, now);
  }

 private:
  Clock clock_;
  double start_;
};

/// The cost of work so far: CPU seconds of this process by part of the work, and counts of things
/// done. Both keep the order in which their names were first given.
struct Costs {
  using List = std::vector<std::pair<std::string, double>>;
  List seconds;
  List counts;

  /// Does the work, and adds its CPU seconds to the part, even if the work throws.
  template <class Work>
  auto timed(std::string_view part, const Work& work) {
    const Timing timing{*this, part, Lap()};
    return work();
  }
  void add_seconds(std::string_view part, double more) { entry(seconds, part) += more; }
  void count(std::string_view what, double more = 1) { entry(counts, what) += more; }

  /// CPU seconds of a part, or a count. \return NaN for a name that was never given
  double seconds_of(std::string_view part) const { return value(seconds, part); }
  double count_of(std::string_view what) const { return value(counts, what); }

 private:
  struct Timing {
    Costs& costs;
    std::string_view part;
    Lap lap;
    ~Timing() { costs.add_seconds(part, lap.seconds()); }
  };
  static double& entry(List& list, std::string_view name);
  static double value(const List& list, std::string_view name);
};

}  // namespace suture::sims
