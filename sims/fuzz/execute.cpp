// The runner sees exceptions and refusals itself; everything else is left to the checks.
#include "sims/fuzz/execute.h"

#include <bit>
#include <cmath>

#include "kernel/errors.h"
#include "kernel/hash.h"
#include "kernel/measure/measures.h"
#include "kernel/random.h"
#include "sims/flows/motions.h"
#include "sims/fuzz/displacement.h"
#include "surgery/tracker.h"

namespace suture::sims {

namespace {

using Kind = Operation::Kind;

/// About how many crossings a remodel would find, and how many planes the lattice has on an axis.
struct Cost {
  double crossings = 0, planes = 0;
};

Cost remodel_cost(const Triangles& surface, double cell) {
  Cost cost;
  for (const Triangle& t : surface.triangles) {
    const Point &a = surface.positions[t[0]], &b = surface.positions[t[1]],
                &c = surface.positions[t[2]];
    const Point u = (b - a) / cell, v = (c - a) / cell;
    cost.crossings += u.lpNorm<1>() + v.lpNorm<1>() + u.cross(v).lpNorm<1>() / 2;
  }
  const Box box = bounding_box(surface.positions);
  cost.planes = ((box.high - box.low) / cell).maxCoeff();
  return cost;
}

/// A fuzzer wants many small cases: what would take a second is left to other tests.
bool too_costly(const Tracker& tracker, Kind kind) {
  constexpr double kMostCrossings = 1e5, kMostPlanes = 1e4, kMostTriangles = 2e4;
  constexpr double kRestarts = 30;  // the paper's order cuts again at each gridlock
  const Triangles& surface = tracker.surface();
  const TrackerOptions& o = tracker.options();
  if (kind == Kind::remodel) {
    const Cost cost = remodel_cost(surface, o.cell_size);
    const double most = kMostCrossings / (o.collapse == Collapse::paper ? kRestarts : 1);
    return !(cost.crossings <= most && cost.planes <= kMostPlanes);
  }
  if (kind != Kind::improve) return false;
  const double finest = o.quality.chord_error > 0 ? o.quality.finest : 1;
  const double edge = (o.quality.edge_length > 0 ? o.quality.edge_length : o.cell_size) * finest *
                      o.quality.longest;
  const Cost cost = remodel_cost(surface, edge);
  return !(4 * cost.crossings <= kMostTriangles && cost.planes <= kMostPlanes);
}

/// Each component's vertices have a velocity of their own.
std::vector<Point> body_velocities(const Triangles& surface, Keys& keys) {
  const double speed = keys.number("speed", Range::any(), 1);
  Random random(static_cast<std::uint64_t>(keys.integer("seed", Range::any(), 0)));
  const Components bodies = components(surface);
  std::vector<Point> of_body(bodies.count);
  for (Point& v : of_body)
    v = speed * Point{random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(-1, 1)};
  std::vector<Point> velocities(surface.positions.size(), Point::Zero());
  for (std::size_t t = 0; t < surface.triangles.size(); ++t)
    for (const std::uint32_t v : surface.triangles[t])
      velocities[v] = of_body[bodies.of_triangle[t]];
  return velocities;
}

std::string advance(Tracker& tracker, const Operation& operation) {
  std::map<std::string, Keys::Entry> entries;
  for (const auto& [key, value] : operation.values) entries[key] = {value, "advance"};
  Keys keys(std::move(entries), "advance", "an advance");
  const std::string kind = keys.one_of("motion", motion_names());
  const double dt = keys.number("dt", Range::any());
  std::vector<Point> velocities;
  if (kind == "bodies") velocities = body_velocities(tracker.surface(), keys);
  make_motion(kind, keys, velocities)->advance(tracker, dt);
  return kind;
}

void displace(Tracker& tracker, const Operation& operation) {
  std::vector<Point> positions = tracker.surface().positions;
  const TrackerOptions& o = tracker.options();
  perturb(positions, perturbation_of(operation), {o.cell_size, o.origin});
  tracker.displace(std::move(positions));
}

std::uint64_t digest_of(std::uint64_t seed, const Triangles& surface) {
  std::uint64_t h = mixed(kGoldenStep, seed);
  for (const Point& p : surface.positions)
    for (int a = 0; a < 3; ++a) h = mixed(h, std::bit_cast<std::uint64_t>(p[a]));
  for (const Triangle& t : surface.triangles)
    for (const std::uint32_t v : t) h = mixed(h, v);
  return h;
}

/// The state of one run.
class Run {
 public:
  Run(const FuzzCase& c, const CheckChoice& checks, const CaseWatcher& watcher)
      : case_(c), checks_(checks), watcher_(watcher), tally_(run_.counts.generators[c.generator]) {
    run_.counts.cases = tally_.cases = 1;
  }

  CaseRun go() {
    std::optional<Tracker> tracker;
    if (attempt([&] { tracker.emplace(case_.surface, case_.options); }))
      for (const Operation& operation : case_.operations) {
        if (tracker->surface().triangles.empty()) break;
        if (too_costly(*tracker, operation.kind)) {
          ++run_.counts.ended["too costly for a fuzzer"];
          break;
        }
        if (watcher_) watcher_(run_.operations, tracker->surface());
        ++run_.operations;
        if (!step(*tracker, operation)) break;
      }
    run_.counts.digest = digest_of(case_.seed, tracker ? tracker->surface() : Triangles{});
    return std::move(run_);
  }

 private:
  void fail(const std::string& check, const std::string& cause) {
    run_.counts.failures.push_back({case_.seed, check, cause.substr(0, cause.find('\n')), {}});
  }

  /// \return whether the case goes on
  template <class F>
  bool attempt(F call) {
    try {
      call();
      return true;
    } catch (const InvalidInput& error) {
      ++run_.counts.ended[kind_of_cause(error.what())];
    } catch (const std::exception& error) {
      fail("exception", error.what());
    }
    return false;
  }

  bool step(Tracker& tracker, const Operation& operation) {
    const Triangles before = tracker.surface();
    std::optional<SurgeryReport> surgery;
    std::optional<QualityReport> quality;
    std::string done;
    const bool fine = attempt([&] {
      switch (operation.kind) {
        case Kind::advance:
          done = "advance " + advance(tracker, operation);
          break;
        case Kind::displace:
          displace(tracker, operation);
          done = "displace " + std::get<std::string>(operation.values.at("how"));
          break;
        case Kind::remodel:
          surgery = tracker.remodel();
          done = "remodel";
          break;
        case Kind::improve:
          quality = tracker.improve();
          done = "improve";
      }
    });
    if (!fine) {
      if (run_.counts.failures.empty() && !same_bits(before, tracker.surface()))
        fail("bits", "an operation refused as bad input changed the surface");
      return false;
    }
    ++run_.counts.operations[done];
    if (surgery) count(*surgery, tracker.surface());
    const bool goes_on =
        judge({case_.seed, case_.options, before, tracker.surface(), surgery ? &*surgery : nullptr,
               quality ? &*quality : nullptr, moved_});
    moved_ = !surgery || (moved_ && surgery->outcome != Outcome::committed);
    return goes_on;
  }

  void count(const SurgeryReport& surgery, const Triangles& surface) {
    ++run_.counts.remodels;
    ++tally_.remodels;
    if (surgery.outcome == Outcome::committed) {
      ++run_.counts.surgeries;
      ++tally_.surgeries;
    }
    if (surgery.outcome == Outcome::refused) ++run_.counts.refused[kind_of_cause(surgery.failure)];
    run_.counts.triangles += surface.triangles.size();
    run_.counts.largest_mesh =
        std::max<std::uint64_t>(run_.counts.largest_mesh, surface.triangles.size());
  }

  bool judge(const Observation& o) {
    const bool exact = case_.options.arithmetic == Arithmetic::filtered ||
                       case_.options.arithmetic == Arithmetic::rational;
    if (o.surgery && o.surgery->outcome == Outcome::refused && exact)
      fail("refused", o.surgery->failure);
    for (const FuzzCheck& check : fuzz_checks()) {
      if (!run_.counts.failures.empty()) return false;
      if (!checks_.asks(check, case_.seed)) continue;
      ++run_.counts.checks[check.name];
      try {
        if (const Objection objection = check.object(o)) fail(check.name, *objection);
      } catch (const std::exception& error) {
        fail(check.name, std::string("it threw: ") + error.what());
      }
    }
    return run_.counts.failures.empty();
  }

  const FuzzCase& case_;
  const CheckChoice& checks_;
  const CaseWatcher& watcher_;
  CaseRun run_;
  GeneratorTally& tally_;
  bool moved_ = true;
};

}  // namespace

CaseRun run_case(const FuzzCase& c, const CheckChoice& checks, const CaseWatcher& watcher) {
  return Run(c, checks, watcher).go();
}

}  // namespace suture::sims
