// Work done in processes of its own: what crashes, hangs or eats memory there, ends only there.
#include "sims/support/process_pool.h"

#include <fmt/format.h>
#include <poll.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <chrono>
#include <cmath>
#include <csignal>
#include <cstring>
#include <ctime>
#include <fstream>

#include "kernel/errors.h"

namespace suture::sims {
namespace {

using Clock = std::chrono::steady_clock;
constexpr double kPatience = 10;  // seconds by the clock for each CPU second that is allowed
constexpr char kEnd = '\n';       // after what the work returned: it was not cut short

struct Child {
  std::size_t index;
  pid_t pid;
  int pipe;
  Clock::time_point until;
  Ended ended;
};

double seconds(const timeval& t) {
  return static_cast<double>(t.tv_sec) + 1e-6 * static_cast<double>(t.tv_usec);
}
double megabytes(const rusage& usage) { return static_cast<double>(usage.ru_maxrss) * 1024e-6; }

void write_all(int file, const std::string& bytes) {
  for (std::size_t done = 0; done < bytes.size();) {
    const ssize_t n = write(file, bytes.data() + done, bytes.size() - done);
    if (n < 0 && errno != EINTR) _exit(1);
    done += n > 0 ? static_cast<std::size_t>(n) : 0;
  }
}

void limit(double cpu_seconds) {
  const rlimit no_core{0, 0};
  setrlimit(RLIMIT_CORE, &no_core);
  if (!std::isfinite(cpu_seconds)) return;
  const auto whole = static_cast<rlim_t>(std::ceil(cpu_seconds));
  const rlimit time{whole, whole + 5};
  setrlimit(RLIMIT_CPU, &time);
}

[[noreturn]] void be_child(int pipe, double cpu_seconds, const std::function<std::string()>& work) {
  prctl(PR_SET_PDEATHSIG, SIGKILL);  // nothing is left running where the parent is killed
  limit(cpu_seconds);
  try {
    write_all(pipe, work() + kEnd);
  } catch (...) {
    std::signal(SIGABRT, SIG_DFL);
    std::abort();
  }
  _exit(0);
}

Child start(std::size_t index, double cpu_seconds, const std::function<std::string()>& work) {
  int ends[2];
  if (pipe(ends) != 0)
    throw InvalidInput(
        fmt::format("a pipe cannot be made ({}); give fewer --jobs", std::strerror(errno)));
  const pid_t pid = fork();
  if (pid == 0) {
    close(ends[0]);
    be_child(ends[1], cpu_seconds, work);
  }
  close(ends[1]);
  if (pid < 0) {
    close(ends[0]);
    throw InvalidInput(
        fmt::format("a process cannot be started ({}); give fewer --jobs", std::strerror(errno)));
  }
  constexpr double longest = 1e8;  // a clock's own range is not reached
  const std::chrono::duration<double> patience(std::min(longest, kPatience * cpu_seconds + 1));
  return {index,
          pid,
          ends[0],
          Clock::now() + std::chrono::duration_cast<Clock::duration>(patience),
          {}};
}

/// Reads what has come. \return whether there may be more
bool read_some(Child& child) {
  char buffer[4096];
  const ssize_t n = read(child.pipe, buffer, sizeof buffer);
  if (n > 0) child.ended.said.append(buffer, static_cast<std::size_t>(n));
  return n > 0 || (n < 0 && errno == EINTR);
}

void reap(Child& child) {
  close(child.pipe);
  int status = 0;
  rusage usage{};
  while (wait4(child.pid, &status, 0, &usage) < 0 && errno == EINTR) {
  }
  Ended& e = child.ended;
  e.cpu_seconds = seconds(usage.ru_utime) + seconds(usage.ru_stime);
  e.peak_megabytes = megabytes(usage);
  e.signal = WIFSIGNALED(status) ? WTERMSIG(status) : 0;
  e.out_of_time = e.out_of_time || e.signal == SIGXCPU;
  e.finished = WIFEXITED(status) && !e.said.empty() && e.said.back() == kEnd;
  if (e.finished)
    e.said.pop_back();
  else
    e.said.clear();
}

/// Waits until one of the children has said something or is out of time; \return those that ended.
std::vector<Child> wait_for_some(std::vector<Child>& running) {
  std::vector<pollfd> files;
  Clock::time_point next = running.front().until;
  for (const Child& child : running) {
    files.push_back({child.pipe, POLLIN, 0});
    next = std::min(next, child.until);
  }
  const auto left = std::chrono::duration_cast<std::chrono::milliseconds>(next - Clock::now());
  constexpr std::int64_t longest = 60000;
  poll(files.data(), files.size(),
       static_cast<int>(std::clamp<std::int64_t>(left.count() + 1, 0, longest)));
  std::vector<Child> over;
  for (std::size_t i = running.size(); i-- > 0;) {
    Child& child = running[i];
    bool more = true;
    if (files[i].revents != 0)
      more = read_some(child);
    else if (Clock::now() > child.until && !child.ended.out_of_time) {
      child.ended.out_of_time = true;
      kill(child.pid, SIGKILL);
    }
    if (more) continue;
    reap(child);
    over.push_back(std::move(child));
    running.erase(running.begin() + static_cast<std::ptrdiff_t>(i));
  }
  return over;
}

}  // namespace

std::string Ended::words() const {
  if (finished) return "";
  if (out_of_time) return fmt::format("out of time after {:.1f} CPU seconds", cpu_seconds);
  if (signal != 0) return fmt::format("killed by signal {} ({})", signal, strsignal(signal));
  return "ended without a result";
}

void in_processes(const std::vector<std::size_t>& order, const ProcessOptions& options,
                  const std::function<std::string(std::size_t)>& work,
                  const std::function<void(std::size_t, const Ended&)>& ended) {
  std::vector<Child> running;
  try {
    for (auto next = order.begin(); next != order.end() || !running.empty();) {
      while (next != order.end() && running.size() < static_cast<std::size_t>(options.jobs)) {
        const std::size_t index = *next++;
        running.push_back(start(index, options.limit_seconds, [&] { return work(index); }));
      }
      for (const Child& child : wait_for_some(running)) ended(child.index, child.ended);
    }
  } catch (...) {
    for (Child& child : running) {
      kill(child.pid, SIGKILL);
      reap(child);
    }
    throw;
  }
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

double process_seconds() {
  timespec now{};
  clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

double peak_megabytes() {
  std::ifstream status("/proc/self/status");
  for (std::string line; std::getline(status, line);)
    if (line.rfind("VmHWM:", 0) == 0) return std::strtod(line.c_str() + 6, nullptr) * 1024e-6;
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  return megabytes(usage);
}

void forget_peak() { std::ofstream("/proc/self/clear_refs") << "5\n"; }

}  // namespace suture::sims
