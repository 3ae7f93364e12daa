// Work done in processes of its own: what crashes, hangs or eats memory there, ends only there.
#pragma once

#include <functional>
#include <limits>
#include <string>
#include <vector>

namespace suture::sims {

struct ProcessOptions {
  int jobs = 1;  ///< processes at a time, >= 1
  /// CPU seconds after which one is ended; by the clock it has ten times that.
  double limit_seconds = std::numeric_limits<double>::infinity();
};

/// How a piece of work ended.
struct Ended {
  std::string said;                            ///< what the work returned; empty unless it finished
  bool finished = false;                       ///< the work returned
  bool out_of_time = false;                    ///< it was ended for that
  int signal = 0;                              ///< that killed it, or 0
  double cpu_seconds = 0, peak_megabytes = 0;  ///< of the whole process

  std::string words() const;  ///< why it did not finish
};

/// Calls work(i) for each i of `order`, in that order, each in a forked copy of this process, and
/// ended(i, how) here as each ends, in whatever order they do. What `work` throws counts as a
/// crash: catch what has a meaning. \pre this process has one thread \throw InvalidInput if the
/// system allows no further process
void in_processes(const std::vector<std::size_t>& order, const ProcessOptions& options,
                  const std::function<std::string(std::size_t)>& work,
                  const std::function<void(std::size_t, const Ended&)>& ended);

/// Runs a program, found as a shell finds it, in a folder. \return its exit code, 127 if there is
/// none
int run_program(const std::vector<std::string>& arguments, const std::string& folder);

/// CPU seconds of this process since it began.
double process_seconds();
/// The most memory that this process has held so far, in MB (10⁶ bytes).
double peak_megabytes();
/// Lets peak_megabytes start from what is held now, where the system can.
void forget_peak();

}  // namespace suture::sims
