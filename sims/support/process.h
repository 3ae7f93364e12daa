// A forked copy of this process that works by itself and says what it finds.
#pragma once

#include <sys/types.h>

#include <functional>
#include <limits>
#include <string>
#include <vector>

namespace suture::sims {

/// Sends a message, of any bytes, to the process that forked this one.
using Say = std::function<void(const std::string& message)>;

/// The end of a process, and what it used.
struct Ended {
  bool finished = false;     ///< its work returned and said something, which came whole
  bool out_of_time = false;  ///< it was ended for that
  int signal = 0;            ///< that killed it, or 0
  int exit_code = 0;
  double cpu_seconds = 0, peak_megabytes = 0;
  std::string said;  ///< its last message, which is the only one of many; empty unless it finished

  std::string words() const;  ///< why it did not finish; empty if it did
};

/// A running process; it is killed if it still runs when this goes.
class Process {
 public:
  /// Forks. The copy does the work with at most so many MB of addresses and ends with exit code 0;
  /// with 3 where the work throws a std::exception, whose words go to its standard error.
  /// \pre this process has one thread \throw InvalidInput if the system allows no further process
  explicit Process(const std::function<void(const Say&)>& work,
                   double megabytes = std::numeric_limits<double>::infinity());
  ~Process();
  Process(Process&& other) noexcept;
  Process& operator=(Process&&) = delete;

  int pipe() const { return pipe_; }  ///< readable when messages or the end have come
  double cpu_seconds() const;         ///< that it has used so far

  /// Appends the messages that have come whole, without waiting. \return whether it still talks
  bool hear(std::vector<std::string>& messages);
  void kill();
  Ended wait();  ///< for its end; once

 private:
  pid_t pid_ = -1;
  int pipe_ = -1;
  std::string unread_;
};

/// Runs a program, found as a shell finds it, in a folder. \return its exit code, 127 if there is
/// none
int run_program(const std::vector<std::string>& arguments, const std::string& folder);

}  // namespace suture::sims
