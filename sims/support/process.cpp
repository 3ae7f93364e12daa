// fork and pipe; a message is its length in eight bytes and then its own.
#include "sims/support/process.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <signal.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <ctime>
#include <utility>

#include "kernel/errors.h"

namespace suture::sims {
namespace {

double seconds(const timeval& t) {
  return static_cast<double>(t.tv_sec) + 1e-6 * static_cast<double>(t.tv_usec);
}

void write_all(int file, const char* bytes, std::size_t count) {
  for (std::size_t done = 0; done < count;) {
    const ssize_t n = write(file, bytes + done, count - done);
    if (n < 0 && errno == EINTR) continue;
    if (n <= 0) throw InternalFailure("worker", "nobody listens to this process");
    done += static_cast<std::size_t>(n);
  }
}

void send(int file, const std::string& message) {
  const std::uint64_t length = message.size();
  write_all(file, reinterpret_cast<const char*>(&length), sizeof length);
  write_all(file, message.data(), message.size());
}

/// Takes the messages that are whole off the front of what was read.
void take_messages(std::string& unread, std::vector<std::string>& messages) {
  std::size_t at = 0;
  std::uint64_t length = 0;
  while (unread.size() - at >= sizeof length) {
    std::memcpy(&length, unread.data() + at, sizeof length);
    if (unread.size() - at - sizeof length < length) break;
    messages.push_back(unread.substr(at + sizeof length, length));
    at += sizeof length + length;
  }
  unread.erase(0, at);
}

void limit(double megabytes) {
  const rlimit no_core{0, 0};
  setrlimit(RLIMIT_CORE, &no_core);
  if (!std::isfinite(megabytes)) return;
  const auto bytes = static_cast<rlim_t>(1e6 * megabytes);
  const rlimit memory{bytes, bytes};
  setrlimit(RLIMIT_AS, &memory);
}

[[noreturn]] void be_child(int pipe, const std::function<void(const Say&)>& work) {
  prctl(PR_SET_PDEATHSIG, SIGKILL);  // nothing is left running where the parent is killed
  try {
    work([pipe](const std::string& message) { send(pipe, message); });
  } catch (const std::exception& error) {
    std::fputs((std::string("worker: ") + error.what() + "\n").c_str(), stderr);
    _exit(3);
  } catch (...) {
    ::signal(SIGABRT, SIG_DFL);
    std::abort();
  }
  _exit(0);
}

}  // namespace

std::string Ended::words() const {
  if (finished) return "";
  if (out_of_time) return fmt::format("out of time after {:.1f} CPU seconds", cpu_seconds);
  if (signal != 0) return fmt::format("killed by signal {} ({})", signal, strsignal(signal));
  if (exit_code != 0) return fmt::format("ended with exit code {}", exit_code);
  return "ended without a result";
}

Process::Process(const std::function<void(const Say&)>& work, double megabytes) {
  int ends[2];
  if (pipe2(ends, O_CLOEXEC) != 0)
    throw InvalidInput(
        fmt::format("a pipe cannot be made ({}); give fewer jobs", std::strerror(errno)));
  std::fflush(nullptr);  // else the copy would have the same text to write once more
  pid_ = fork();
  if (pid_ == 0) {
    close(ends[0]);
    limit(megabytes);
    be_child(ends[1], work);
  }
  const int error = errno;
  close(ends[1]);
  pipe_ = ends[0];
  if (pid_ < 0) {
    close(pipe_);
    throw InvalidInput(
        fmt::format("a process cannot be started ({}); give fewer jobs", std::strerror(error)));
  }
  fcntl(pipe_, F_SETFL, O_NONBLOCK);
}

Process::Process(Process&& other) noexcept
    : pid_(std::exchange(other.pid_, -1)),
      pipe_(std::exchange(other.pipe_, -1)),
      unread_(std::move(other.unread_)) {}

Process::~Process() {
  if (pid_ > 0) {
    kill();
    wait();
  }
  if (pipe_ >= 0) close(pipe_);
}

double Process::cpu_seconds() const {
  clockid_t clock{};
  timespec now{};
  if (clock_getcpuclockid(pid_, &clock) != 0 || clock_gettime(clock, &now) != 0) return 0;
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

bool Process::hear(std::vector<std::string>& messages) {
  char buffer[65536];
  ssize_t n = 0;
  while ((n = read(pipe_, buffer, sizeof buffer)) > 0)
    unread_.append(buffer, static_cast<std::size_t>(n));
  const bool over = n == 0 || (errno != EAGAIN && errno != EINTR);
  take_messages(unread_, messages);
  return !over;
}

void Process::kill() {
  if (pid_ > 0) ::kill(pid_, SIGKILL);
}

Ended Process::wait() {
  int status = 0;
  rusage usage{};
  while (wait4(pid_, &status, 0, &usage) < 0 && errno == EINTR) {
  }
  pid_ = -1;
  Ended ended;
  ended.cpu_seconds = seconds(usage.ru_utime) + seconds(usage.ru_stime);
  ended.peak_megabytes = static_cast<double>(usage.ru_maxrss) * 1024e-6;
  ended.signal = WIFSIGNALED(status) ? WTERMSIG(status) : 0;
  ended.exit_code = WIFEXITED(status) ? WEXITSTATUS(status) : 0;
  ended.finished = WIFEXITED(status) && ended.exit_code == 0 && unread_.empty();
  return ended;
}

int run_program(const std::vector<std::string>& arguments, const std::string& folder) {
  const pid_t pid = fork();
  if (pid == 0) {
    std::vector<char*> list;
    for (const std::string& a : arguments) list.push_back(const_cast<char*>(a.c_str()));
    list.push_back(nullptr);
    if (chdir(folder.c_str()) == 0) execvp(list[0], list.data());
    _exit(127);
  }
  int status = 0;
  while (pid > 0 && waitpid(pid, &status, 0) < 0 && errno == EINTR) {
  }
  return pid > 0 && WIFEXITED(status) ? WEXITSTATUS(status) : 126;
}

}  // namespace suture::sims
