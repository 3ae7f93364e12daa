// Runs each row of the table of extremes in a process of its own, so that a crash, a hang and the
// peak of memory are that row's alone. CSV on standard output or in a file, progress on the other.
// usage: extremes_bench [--only NAME] [--out FILE] [--seconds LIMIT]
#include <fmt/core.h>
#include <signal.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cstdlib>
#include <cstring>
#include <ctime>

#include "kernel/audit.h"
#include "kernel/errors.h"
#include "kernel/files.h"
#include "tests/bench/extremes/rows.h"

namespace suture::extremes {

double cpu_seconds() {
  return static_cast<double>(std::clock()) / static_cast<double>(CLOCKS_PER_SEC);
}

std::string text(const char* format, double value) {
  char buffer[64];
  std::snprintf(buffer, sizeof buffer, format, value);
  return buffer;
}

Result perform(Triangles& surface, const TrackerOptions& options, const Task& task) {
  Result result;
  result.before = surface.triangles.size();
  const double start = cpu_seconds();
  try {
    Tracker tracker(surface, options);
    result.outcome = "improved";
    if (task.remodel) {
      const SurgeryReport report = tracker.remodel();
      result.outcome = report.outcome == Outcome::committed   ? "committed"
                       : report.outcome == Outcome::unchanged ? "unchanged"
                                                              : "refused: " + report.failure;
    }
    if (task.improve) tracker.improve();
    result.seconds = cpu_seconds() - start;
    surface = tracker.surface();
    const Audit a = audit(surface);
    if (!surface.triangles.empty() && !a.closed_manifold()) result.outcome = "JUNK: " + a.first;
  } catch (const InvalidInput& error) {
    result.outcome = std::string("InvalidInput: ") + error.what();
  } catch (const std::exception& error) {
    result.outcome = std::string("FAILED: ") + error.what();
  }
  if (result.seconds == 0) result.seconds = cpu_seconds() - start;
  result.after = surface.triangles.size();
  return result;
}

namespace {

std::string quoted(std::string s) {
  for (std::size_t at = 0; (at = s.find('"', at)) != std::string::npos; at += 2) s.insert(at, "\"");
  return s.find_first_of(",\"\n") == std::string::npos ? s : '"' + s + '"';
}

/// outcome … cpu of the row, as the child says it.
std::string child_says(const Row& row) {
  Result r;
  try {
    r = row.run();
  } catch (const std::exception& error) {
    r.outcome = std::string("FAILED: ") + error.what();
  }
  return fmt::format("{},{},{},{},{},{:.3f}\t{}", quoted(r.outcome),
                     std::isnan(r.error) ? "" : text("%.3e", r.error), r.bits, r.before, r.after,
                     r.seconds, quoted(r.note));
}

std::string measure(const Row& row, unsigned limit) {
  int ends[2];
  if (pipe(ends) != 0) throw InternalFailure("extremes", "no pipe");
  const pid_t child = fork();
  if (child == 0) {
    const rlimit most{limit, limit + 5};
    setrlimit(RLIMIT_CPU, &most);
    const std::string said = child_says(row);
    const auto written = write(ends[1], said.data(), said.size());
    _exit(written == static_cast<ssize_t>(said.size()) ? 0 : 1);
  }
  close(ends[1]);
  std::string said;
  char buffer[4096];
  for (ssize_t n = 0; (n = read(ends[0], buffer, sizeof buffer)) > 0;)
    said.append(buffer, static_cast<std::size_t>(n));
  close(ends[0]);
  int status = 0;
  rusage used{};
  wait4(child, &status, 0, &used);
  const double peak = static_cast<double>(used.ru_maxrss) / 1024;
  if (WIFSIGNALED(status)) {
    const double cpu = static_cast<double>(used.ru_utime.tv_sec + used.ru_stime.tv_sec);
    const std::string how = WTERMSIG(status) == SIGXCPU
                                ? fmt::format("LIMIT: over {} s of CPU", limit)
                                : fmt::format("CRASH: signal {}", WTERMSIG(status));
    return fmt::format("{},{},{},,,,,{:.1f},{:.0f},", quoted(row.extreme), quoted(row.value), how,
                       cpu, peak);
  }
  const std::size_t tab = said.find('\t');
  return fmt::format("{},{},{},{:.0f},{}", quoted(row.extreme), quoted(row.value),
                     said.substr(0, tab), peak, said.substr(tab + 1));
}

}  // namespace

}  // namespace suture::extremes

int main(int count, char** arguments) {
  using namespace suture::extremes;
  std::string only, out;
  unsigned limit = 900;
  for (int i = 1; i + 1 < count; i += 2) {
    if (std::strcmp(arguments[i], "--only") == 0) only = arguments[i + 1];
    if (std::strcmp(arguments[i], "--out") == 0) out = arguments[i + 1];
    if (std::strcmp(arguments[i], "--seconds") == 0)
      limit = static_cast<unsigned>(std::max(1, std::atoi(arguments[i + 1])));
  }
  std::vector<Row> rows;
  add_scale_rows(rows);
  add_lattice_rows(rows);
  add_size_rows(rows);
  add_shape_rows(rows);
  add_time_rows(rows);
  std::erase_if(rows, [&](const Row& r) { return r.extreme.find(only) == std::string::npos; });
  std::string table =
      "extreme,value,outcome,volume_error,bits_equal,triangles_before,triangles_after,cpu_seconds,"
      "peak_mb,note\n";
  for (std::size_t i = 0; i < rows.size(); ++i) {
    fmt::print(stderr, "[{}/{}] ", i + 1, rows.size());
    std::fflush(stderr);
    const std::string line = measure(rows[i], limit);
    fmt::print(stderr, "{}\n", line.substr(0, 200));
    table += line + "\n";
  }
  if (out.empty())
    fmt::print("{}", table);
  else
    suture::write_file(out, table);
}
