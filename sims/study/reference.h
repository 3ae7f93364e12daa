// The reference that a study measures errors against: the first surface, as it was or carried by
// the exact flow, a finer run, or a mesh file.
#pragma once

#include "sims/study/plan.h"
#include "sims/support/process_pool.h"

namespace suture::sims {

struct ReferenceOptions {
  /// "start"; "flow", the first surface finely subdivided and carried by the motion alone, exact
  /// where topology does not change; "finest", a finer run; a mesh file; empty: start where the
  /// motion brings everything back, else finest.
  std::string kind;
  double finest = 0.7;   ///< × the least planned cell size, edge length and time step
  ProcessOptions limit;  ///< of the finer run
};

struct Reference {
  std::filesystem::path mesh;
  std::string kind;   ///< "start", "flow", "finest", "file"
  std::string words;  ///< what it is, for people
};

/// \return whether the scene's motion, left alone by surgery and improvement, brings every vertex
/// of the first surface back to where it was, within a thousandth of a cell.
bool comes_back(const std::filesystem::path& scene);

/// The surface with every triangle cut in four as often as keeps it below `most` triangles: the
/// same points of space, to rounding.
Triangles quartered(Triangles surface, std::size_t most);

/// The changes of the scene that make the finer run: space and time steps below all of the plan's,
/// remodels and improvements as often in time as the scene has them, arithmetic filtered.
SceneChanges finest_changes(const Settings& own, const std::vector<PlannedRun>& runs,
                            double factor);

/// The purpose of a reference: its scene, the study's folder, and the runs that it is to be finer
/// than.
struct StudyPlan {
  const std::filesystem::path& scene;
  const std::filesystem::path& folder;
  const std::vector<PlannedRun>& runs;
};

/// Leaves the reference as reference.ply in the folder, with reference.txt that says what it is;
/// one that is there is kept, if it is of this scene and kind. \throw InvalidInput if the finer run
/// fails, the file is no closed manifold, or a flow is asked for and the motion is no velocity
/// field
Reference make_reference(const StudyPlan& study, const ReferenceOptions& options);

}  // namespace suture::sims
