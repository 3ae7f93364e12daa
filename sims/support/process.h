// A forked child that does something which may crash or hang, and writes what came of it.
#pragma once

#include <sys/types.h>

#include <functional>
#include <string>

namespace suture::sims {

/// A running child; killed if it still runs when this goes.
class Child {
 public:
  /// Forks; the child calls work(fd) with the writing end of a pipe, and ends with exit code 0.
  /// \pre one thread \throw InternalFailure if there is no process or pipe to be had
  explicit Child(const std::function<void(int)>& work);
  ~Child();
  Child(Child&& other) noexcept;
  Child& operator=(Child&&) = delete;

  int fd() const { return fd_; }  ///< the reading end; never blocks
  void kill();

  /// Waits for the end. \return how it died, in words; empty if it ended as it should
  std::string wait();
  double cpu_seconds() const;  ///< so far, or of all of its life after wait

 private:
  pid_t pid_ = -1;
  int fd_ = -1;
  double cpu_seconds_ = 0;
};

/// Writes all of it. \throw InternalFailure if the other end has gone
void write_all(int fd, const std::string& text);

/// Whether something hangs: it has used more than the seconds allowed of a core, or ten times as
/// long has passed, so that on a busy machine what only waits for its turn does not hang.
constexpr bool hangs(double cpu_seconds, double passed, double allowed) {
  return cpu_seconds > allowed || passed > 10 * allowed;
}

/// What `work` returned, run in a child; or how the child died.
struct Isolated {
  std::string text;
  std::string death;  ///< "killed by signal 11", or "hang"; empty if all went well
};
Isolated run_isolated(const std::function<std::string()>& work, double seconds);

}  // namespace suture::sims
