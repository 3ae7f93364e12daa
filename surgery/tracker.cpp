// The tracker's state, and what each call promises to leave behind [§3].
#include "surgery/tracker.h"

#include <cmath>
#include <optional>
#include <string>

#include "kernel/audit.h"
#include "kernel/errors.h"
#include "kernel/lists.h"
#include "predicates/floating_point.h"
#include "surgery/advect.h"
#include "surgery/detect/budget.h"
#include "surgery/model/tracker_lattice.h"
#include "surgery/model/unit.h"
#include "surgery/quality/improve.h"
#include "surgery/remodel.h"

namespace suture {

using namespace surgery;

namespace {

void require_in_range(const TrackerOptions& o) {
  constexpr int kMostDepth = 1000;  // (2·depth + 1)³ cells are looked at for each complex cell
  if (o.depth < 0 || o.depth > kMostDepth)
    throw InvalidInput("depth is " + std::to_string(o.depth) + "; it must be 0 to " +
                       std::to_string(kMostDepth) + " cells");
  if (!o.origin.allFinite()) throw InvalidInput("the lattice's origin must be finite");
  require_unit(o);
  if (!(o.straighten_turn >= 0 && o.straighten_turn <= 180))
    throw InvalidInput("straighten_turn must be 0 to 180 degrees");
  if (!(o.jitter >= 0 && o.jitter <= 0.1))
    throw InvalidInput("jitter is " + std::to_string(o.jitter) + "; it must be 0 to 0.1 of a cell");
  if (o.most_restarts < 0) throw InvalidInput("most_restarts must be 0 or more");
  const QualityOptions& q = o.quality;
  const bool lengths = q.edge_length >= 0 && q.shortest >= 0 && q.longest > q.shortest &&
                       std::isfinite(q.edge_length) && std::isfinite(q.longest) &&
                       q.chord_error >= 0 && std::isfinite(q.chord_error) && q.finest > 0 &&
                       q.finest <= 1;
  const bool shapes = q.smallest_angle >= 0 && q.smallest_angle <= 60 && q.largest_angle >= 60 &&
                      q.largest_angle <= 180 && q.feature_angle >= 0 && q.feature_angle <= 180 &&
                      q.turn_bound >= 0 && q.turn_bound <= 180;
  if (!lengths || !shapes || !(q.volume_bound >= 0) || q.passes < 0)
    throw InvalidInput(
        "a quality option is out of range: lengths are finite with 0 <= shortest < longest, finest "
        "is above 0 and at most 1, angles 0 to 180 degrees (smallest at most 60, largest at "
        "least), "
        "chord_error, volume_bound and passes 0 or more");
}

/// A remodel in the unit that suits the cells, or in the scene's own where a new vertex would have
/// a coordinate that doubles cannot hold there: one next to a plane at 0 may be subnormal.
SurgeryReport remodel_in_unit(Surface& surface, const TrackerOptions& options, const Oracle& oracle,
                              Trace* trace) {
  const int unit = unit_exponent(options);
  if (unit == 0) return remodel(surface, options, oracle, trace);
  Surface work = surface;
  multiply(work, -unit);
  SurgeryReport report = remodel(work, times_power(options, -unit), oracle, trace);
  multiply(report, unit);
  if (report.outcome != Outcome::committed) return report;
  if (!multiply(work, unit)) return remodel(surface, options, oracle, trace);
  surface = std::move(work);
  return report;
}

struct Improved {
  Mesh mesh;
  QualityReport report;
};

/// The same for an improvement. \return nothing where `unit` cannot hold the result
std::optional<Improved> improve_in_unit(const Surface& surface, const TrackerOptions& options,
                                        const Oracle& oracle, int unit) {
  QualityOptions quality = options.quality;
  if (quality.edge_length == 0) quality.edge_length = options.cell_size;
  quality.edge_length = std::ldexp(quality.edge_length, -unit);
  quality.chord_error = std::ldexp(quality.chord_error, -unit);
  Surface work = surface;
  multiply(work, -unit);
  const Lattice lattice = tracker_lattice(work.triangles.positions, times_power(options, -unit));
  QualityReport report = improve(work.mesh, quality, &lattice, &oracle);
  multiply(report, unit);
  if (!multiply(work.mesh, unit)) return std::nullopt;
  return Improved{std::move(work.mesh), std::move(report)};
}

}  // namespace

struct Tracker::State {
  Surface surface;
  TrackerOptions options;
  std::unique_ptr<Oracle> oracle;
  double time = 0;
};

Tracker::Tracker(Triangles surface, const TrackerOptions& options) {
  require_in_range(options);
  require_closed_manifold(surface, "the surface");
  require_room(surface.positions, options);
  require_crossings_fit(surface, tracker_lattice(surface.positions, options));
  state_ = std::make_unique<State>();
  state_->options = options;
  state_->oracle = make_oracle(options.arithmetic);
  state_->surface.mesh = to_mesh(surface);
  state_->surface.triangles = std::move(surface);
}
Tracker::~Tracker() = default;
Tracker::Tracker(Tracker&&) noexcept = default;
Tracker& Tracker::operator=(Tracker&&) noexcept = default;

const Triangles& Tracker::surface() const { return state_->surface.triangles; }
const TrackerOptions& Tracker::options() const { return state_->options; }
double Tracker::time() const { return state_->time; }

void Tracker::advect(const VelocityField& u, double dt) {
  displace(advected(surface().positions, u, state_->time, dt), dt);
}

void Tracker::displace(std::vector<Point> positions, double dt) {
  if (positions.size() != surface().positions.size())
    throw InvalidInput("displace was given " + std::to_string(positions.size()) +
                       " positions for a surface of " + std::to_string(surface().positions.size()) +
                       " vertices; give one for each, in the order of surface().positions");
  for (std::size_t i = 0; i < positions.size(); ++i)
    if (!positions[i].allFinite())
      throw InvalidInput("vertex " + std::to_string(i) +
                         " would move to a place that is not finite; check the velocity field or "
                         "the time step");
  require_room(positions, state_->options);
  for (const auto v : state_->surface.mesh.vertices())
    state_->surface.mesh.point(v) = to_cgal(positions[v]);
  state_->surface.triangles.positions = std::move(positions);
  state_->time += dt;
}

SurfaceDistance Tracker::distance() const { return SurfaceDistance(surface(), state_->options); }

SurgeryReport Tracker::remodel(Trace* trace) {
  require_ieee_arithmetic();  // of this thread, which need not be the one that made the tracker
  return remodel_in_unit(state_->surface, state_->options, *state_->oracle, trace);
}

QualityReport Tracker::improve(Trace* trace) {
  if (surface().triangles.empty()) return {};
  require_ieee_arithmetic();
  Stopwatch watch;
  const State& was = *state_;
  auto found = improve_in_unit(was.surface, was.options, *was.oracle, unit_exponent(was.options));
  if (!found) found = improve_in_unit(was.surface, was.options, *was.oracle, 0);
  QualityReport& report = found->report;
  if (report.subdivisions + report.collapses.done + report.flips + report.flattened == 0) {
    report.vertex_map =
        identity_map(surface().positions.size());  // what was tried has renumbered it
    return std::move(report);
  }
  Triangles improved = to_triangles(found->mesh);
  const Audit result = audit(improved);
  if (!result.closed_manifold()) throw InternalFailure("improve", result.first);
  state_->surface.triangles = std::move(improved);
  state_->surface.mesh = std::move(found->mesh);
  if (trace) trace->stage_ended("improve", watch.lap());
  return std::move(report);
}

}  // namespace suture
