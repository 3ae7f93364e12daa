// fork, pipe, poll: no thread may run in the parent, so that the child is whole.
#include "sims/support/process.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <poll.h>
#include <signal.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <ctime>
#include <utility>

#include "kernel/errors.h"
#include "kernel/trace.h"

namespace suture::sims {

namespace {

[[noreturn]] void run_child(const std::function<void(int)>& work, int fd) {
  prctl(PR_SET_PDEATHSIG, SIGKILL);
  int code = 0;
  try {
    work(fd);
  } catch (const std::exception& error) {
    std::fputs((std::string("fuzz worker: ") + error.what() + "\n").c_str(), stderr);
    code = 3;
  }
  _exit(code);
}

}  // namespace

Child::Child(const std::function<void(int)>& work) {
  int ends[2];
  if (pipe2(ends, O_CLOEXEC) != 0) throw InternalFailure("fuzz", std::strerror(errno));
  std::fflush(nullptr);
  pid_ = fork();
  if (pid_ == 0) {
    close(ends[0]);
    run_child(work, ends[1]);
  }
  close(ends[1]);
  fd_ = ends[0];
  if (pid_ < 0) {
    close(fd_);
    throw InternalFailure("fuzz", std::string("no process: ") + std::strerror(errno));
  }
  fcntl(fd_, F_SETFL, O_NONBLOCK);
}

Child::Child(Child&& other) noexcept
    : pid_(std::exchange(other.pid_, -1)),
      fd_(std::exchange(other.fd_, -1)),
      cpu_seconds_(other.cpu_seconds_) {}

Child::~Child() {
  if (pid_ > 0) {
    kill();
    wait();
  }
  if (fd_ >= 0) close(fd_);
}

double Child::cpu_seconds() const {
  clockid_t clock{};
  timespec now{};
  if (pid_ <= 0 || clock_getcpuclockid(pid_, &clock) != 0 || clock_gettime(clock, &now) != 0)
    return cpu_seconds_;
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

void Child::kill() {
  if (pid_ > 0) ::kill(pid_, SIGKILL);
}

std::string Child::wait() {
  int status = 0;
  rusage used{};
  while (wait4(pid_, &status, 0, &used) < 0 && errno == EINTR) {
  }
  pid_ = -1;
  const auto seconds = [](const timeval& t) {
    return static_cast<double>(t.tv_sec) + 1e-6 * static_cast<double>(t.tv_usec);
  };
  cpu_seconds_ = seconds(used.ru_utime) + seconds(used.ru_stime);
  if (WIFSIGNALED(status))
    return fmt::format("killed by signal {} ({})", WTERMSIG(status), strsignal(WTERMSIG(status)));
  if (WEXITSTATUS(status) != 0) return fmt::format("ended with exit code {}", WEXITSTATUS(status));
  return {};
}

void write_all(int fd, const std::string& text) {
  for (std::size_t done = 0; done < text.size();) {
    const ssize_t n = ::write(fd, text.data() + done, text.size() - done);
    if (n < 0 && errno == EINTR) continue;
    if (n <= 0) throw InternalFailure("fuzz", "the campaign does not listen");
    done += static_cast<std::size_t>(n);
  }
}

Isolated run_isolated(const std::function<std::string()>& work, double seconds) {
  Child child([&](int fd) { write_all(fd, work()); });
  Isolated result;
  Stopwatch watch;
  char buffer[65536];
  double passed = 0;
  while (true) {
    pollfd ready{child.fd(), POLLIN, 0};
    poll(&ready, 1, static_cast<int>(1 + std::min(50.0, 500 * seconds)));
    const ssize_t n = ::read(child.fd(), buffer, sizeof buffer);
    passed += watch.lap();
    if (n > 0) {
      result.text.append(buffer, static_cast<std::size_t>(n));
    } else if (n == 0) {
      result.death = child.wait();
      return result;
    } else if (hangs(child.cpu_seconds(), passed, seconds)) {
      child.kill();
      child.wait();
      result.death = "hang";
      return result;
    }
  }
}

}  // namespace suture::sims
