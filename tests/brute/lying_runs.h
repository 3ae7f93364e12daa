// Sequences of remodels and improvements under an oracle that lies: what may come of them.
#pragma once

#include <array>
#include <string>

#include "kernel/audit.h"
#include "surgery/model/option_table.h"
#include "surgery/model/tracker_lattice.h"
#include "surgery/quality/improve.h"
#include "surgery/remodel.h"
#include "tests/brute/lying_oracle.h"
#include "tests/surgery/hostile.h"

namespace suture {

using namespace suture::surgery;

inline constexpr std::array<double, 8> kLies = {1e-4, 1e-3, 0.01, 0.03, 0.1, 0.3, 0.6, 1};

struct LyingRun {
  double probability = 0;
  int committed = 0, refused = 0, unchanged = 0, improved = 0;
  std::string fault;  ///< what was committed or left that must not be; empty if nothing
};

namespace lying {

/// Says what is wrong with a surface that should be a closed manifold; empty: nothing is.
inline std::string fault_of(const Surface& surface) {
  if (!(to_triangles(surface.mesh) == surface.triangles)) return "mesh and copy differ";
  if (surface.triangles.triangles.empty()) return {};
  const Audit result = audit(surface.triangles);
  return result.closed_manifold() ? "" : result.first;
}

/// One remodel, judged. \return whether anything is left to go on with
inline bool remodel_once(Surface& surface, const TrackerOptions& options, const Oracle& oracle,
                         LyingRun& run) {
  const Triangles before = surface.triangles;
  const SurgeryReport report = remodel(surface, {options, oracle});
  run.committed += report.outcome == Outcome::committed ? 1 : 0;
  run.refused += report.outcome == Outcome::refused ? 1 : 0;
  run.unchanged += report.outcome == Outcome::unchanged ? 1 : 0;
  if (report.outcome == Outcome::refused && report.failure.empty())
    run.fault = "refused without a reason";
  if (report.outcome != Outcome::committed && !(surface.triangles == before))
    run.fault = "not committed, but other than before";
  if (run.fault.empty()) run.fault = fault_of(surface);
  return run.fault.empty() && !surface.triangles.triangles.empty();
}

/// Does what Tracker::improve does before it would throw. Whatever the oracle says, the result
/// should be a closed manifold.
inline bool improve_once(Surface& surface, const TrackerOptions& options, const Oracle& oracle,
                         LyingRun& run) {
  QualityOptions quality = options.quality;
  quality.edge_length = options.cell_size;
  const Lattice lattice = tracker_lattice(surface.triangles.positions, options);
  const ShiftedLattice nodes{lattice, oracle};
  improve(surface.mesh, quality, &nodes);
  surface.triangles = to_triangles(surface.mesh);
  ++run.improved;
  run.fault = fault_of(surface);
  return run.fault.empty() && !surface.triangles.triangles.empty();
}

inline void move(Surface& surface, double reach, Random& random) {
  for (const auto v : surface.mesh.vertices()) {
    Point& p = surface.triangles.positions[v];
    for (int a = 0; a < 3; ++a) p[a] += random.uniform(-reach, reach);
    surface.mesh.point(v) = to_cgal(p);
  }
}

}  // namespace lying

/// A hostile surface remodelled up to three times with motion in between, and improved by one seed
/// in four; all collapses, placements and probabilities take their turns.
inline LyingRun run_lying(std::uint64_t seed) {
  HostileCase c = HostileCases(seed).make();
  LyingRun run;
  run.probability = kLies[seed % kLies.size()];
  c.options.collapse = kCollapseNames[seed / kLies.size() % kCollapseNames.size()].value;
  c.options.placement = kPlacementNames[seed / 3 % kPlacementNames.size()].value;
  const LyingOracle oracle(run.probability, seed);
  Random random(seed);
  Surface surface{to_mesh(c.surface), c.surface};
  const std::uint64_t rounds = 1 + seed / 5 % 3;
  for (std::uint64_t round = 0; round < rounds; ++round) {
    if (!lying::remodel_once(surface, c.options, oracle, run)) break;
    if (seed / kLies.size() % 4 == 0 && !lying::improve_once(surface, c.options, oracle, run))
      break;
    lying::move(surface, 0.3 * c.options.cell_size, random);
  }
  return run;
}

}  // namespace suture
