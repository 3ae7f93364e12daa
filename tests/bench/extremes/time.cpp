// Rows on time: the same remodel again and again, and steps from tiny to a throw across the
// lattice.
#include <fmt/core.h>

#include "kernel/audit.h"
#include "kernel/errors.h"
#include "sims/flows/fields.h"
#include "tests/bench/extremes/rows.h"
#include "tests/extremes/bodies.h"

namespace suture::extremes {

using namespace suture::surgery;
using namespace suture::sims;

namespace {

/// How often the surface of one call differs from that of the call before, after the first
/// `settle`.
Result again_and_again(int count, const TrackerOptions& options, const Task& task) {
  Result r;
  Tracker tracker(two_balls(12), options);
  r.before = tracker.surface().triangles.size();
  const double start = cpu_seconds();
  int last_change = 0;
  for (int i = 1; i <= count; ++i) {
    const Triangles was = tracker.surface();
    if (task.remodel && tracker.remodel().outcome == Outcome::refused) r.outcome = "refused";
    if (task.improve) tracker.improve();
    if (!same_bits(was, tracker.surface())) last_change = i;
  }
  r.seconds = cpu_seconds() - start;
  r.after = tracker.surface().triangles.size();
  r.outcome = fmt::format("{} of {} calls done", count, count);
  r.bits = last_change < count / 2 ? "yes" : "no";
  r.note = fmt::format("the last call that changed a bit was number {}", last_change);
  return r;
}

/// Steps of length dt: advect, remodel, improve; the error is that of the volume over all of them.
Result steps(const VelocityField& u, double dt, int count) {
  Result r;
  Tracker tracker(two_balls(12), {.cell_size = 0.1});
  tracker.remodel();
  const double was = volume(tracker.surface());
  r.before = tracker.surface().triangles.size();
  const double start = cpu_seconds();
  int committed = 0, done = 0;
  try {
    for (; done < count; ++done) {
      tracker.advect(u, dt);
      const SurgeryReport report = tracker.remodel();
      if (report.outcome == Outcome::refused) r.outcome = "refused: " + report.failure;
      committed += report.outcome == Outcome::committed ? 1 : 0;
      tracker.improve();
    }
    if (r.outcome.empty()) r.outcome = fmt::format("{} steps, {} surgeries", done, committed);
  } catch (const InvalidInput& error) {
    r.outcome = std::string("InvalidInput: ") + error.what();
  }
  r.seconds = cpu_seconds() - start;
  const Triangles& end = tracker.surface();
  if (const Audit a = audit(end); !end.triangles.empty() && !a.closed_manifold())
    r.outcome = "JUNK: " + a.first;
  r.after = end.triangles.size();
  r.error = relative(volume(end), was);
  return r;
}

/// Every vertex thrown by up to `reach` cells, at random: one tangle.
Result thrown(double reach, const Task& task) {
  Tracker tracker(two_balls(reach > 10 ? 3 : 12), {.cell_size = 0.1});
  Random random(5);
  std::vector<Point> to = tracker.surface().positions;
  for (Point& p : to)
    for (double& x : p) x += 0.1 * random.uniform(-reach, reach);
  tracker.displace(to);
  Triangles surface = tracker.surface();
  Result r = perform(surface, {.cell_size = 0.1}, task);
  r.note = fmt::format("{} bodies", components(surface).count);
  return r;
}

}  // namespace

void add_time_rows(std::vector<Row>& rows) {
  const TrackerOptions usual{.cell_size = 0.1};
  rows.push_back(
      {"again and again: remodel", "10000", [=] { return again_and_again(10000, usual, {}); }});
  rows.push_back({"again and again: remodel and improve", "1000",
                  [=] { return again_and_again(1000, usual, {.improve = true}); }});
  const VelocityField noise = curl_noise({.seed = 3, .wavelength = 0.7});
  const VelocityField turn = rotation({.axis = Point(1, 2, 3)});
  const VelocityField pull = stretch({.axis = Point(1, 0.2, 0.1), .rate = 1});
  const VelocityField drift = [](const Point&, double) { return Point(1, 0.7, -0.9); };
  for (const double dt : {1e-12, 1e-9, 1e-6, 1e-3, 0.03, 0.3, 3.0, 30.0}) {
    const std::string value = fmt::format("dt {:g}", dt);
    // Runge and Kutta's steps of several radians blow a surface up until its crossings are refused.
    if (dt < 1) rows.push_back({"steps: curl noise", value, [=] { return steps(noise, dt, 20); }});
    if (dt < 1 || dt > 10)
      rows.push_back({"steps: rotation", value, [=] { return steps(turn, dt, 20); }});
    rows.push_back({"steps: stretch", value, [=] { return steps(pull, dt, dt > 1 ? 1 : 5); }});
    rows.push_back({"steps: drift", value, [=] { return steps(drift, dt, 20); }});
  }
  rows.push_back({"steps: drift", "dt 1e+300", [=] { return steps(drift, 1e300, 20); }});
  for (const double reach : {1e-12, 1e-3, 1.0, 10.0, 100.0})
    for (const bool improve : {false, true})
      rows.push_back({improve ? "thrown at random, with improve" : "thrown at random",
                      fmt::format("{:g} cells", reach),
                      [=] { return thrown(reach, {.improve = improve}); }});
}

}  // namespace suture::extremes
