// What this process has used: seconds by the clock, seconds of its cores, and memory.
#include "sims/support/clock.h"

#include <sys/resource.h>

#include <algorithm>
#include <cstdlib>
#include <ctime>
#include <fstream>
#include <limits>

namespace suture::sims {
namespace {

double read(clockid_t clock) {
  timespec now{};
  clock_gettime(clock, &now);
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

}  // namespace

double wall_seconds() { return read(CLOCK_MONOTONIC); }

double process_seconds() { return read(CLOCK_PROCESS_CPUTIME_ID); }

double peak_megabytes() {
  std::ifstream status("/proc/self/status");
  for (std::string line; std::getline(status, line);)
    if (line.rfind("VmHWM:", 0) == 0) return std::strtod(line.c_str() + 6, nullptr) * 1024e-6;
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  return static_cast<double>(usage.ru_maxrss) * 1024e-6;
}

void forget_peak() { std::ofstream("/proc/self/clear_refs") << "5\n"; }

double& Costs::entry(List& list, std::string_view name) {
  const auto at =
      std::find_if(list.begin(), list.end(), [&](const auto& e) { return e.first == name; });
  return at != list.end() ? at->second : list.emplace_back(name, 0.0).second;
}

double Costs::value(const List& list, std::string_view name) {
  for (const auto& [known, x] : list)
    if (known == name) return x;
  return std::numeric_limits<double>::quiet_NaN();
}

}  // namespace suture::sims
