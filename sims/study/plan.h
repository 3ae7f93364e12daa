// Which runs a study makes of a scene: factors, their levels, and the designs that combine them.
#pragma once

#include "sims/study/settings.h"

namespace suture::sims {

/// A level of a factor is a value, or a multiple of what the scene has.
struct Level {
  Value value;
  bool multiple = false;
};

/// A factor is varied: a setting, or `resolution`, the cell size and the edge length together.
struct Factor {
  std::string name;
  std::vector<std::string> settings;  ///< full names
  std::vector<Level> levels;
};

/// Reads "cell_size=x0.5,0.05": multiples of the scene's own are written with an x.
/// \throw InvalidInput for an unknown factor, no levels, or a multiple of what is no number
Factor read_factor(const std::string& text, const Settings& own);

/// Factors whose levels are all combined with one another.
struct Design {
  std::string name;  ///< "grid", or of the one factor that is varied
  std::vector<Factor> factors;
};

/// The designs that are made of factors: each alone, and all as one grid.
struct DesignChoice {
  bool one = true, grid = true;
};

/// The designs that these factors make. \throw InvalidInput as read_factor, and if one is given
/// twice
std::vector<Design> designs_of(const std::vector<std::string>& factors, const Settings& own,
                               const DesignChoice& choice);

/// The designs where the user names no factors: each choice alone, which tells what it costs, and a
/// grid of the three resolutions (space, time, topology), which change the cost most and depend on
/// one another. A product of everything would be 10⁹ runs.
std::vector<Design> default_designs(const Settings& own, const DesignChoice& choice);

struct PlannedRun {
  SceneChanges changes;  ///< only what differs from the scene
  std::string design;    ///< "own", or the design's name
};

/// x to six digits, as a person would write it.
double rounded_for_people(double x);

/// The scene's own run and those of the designs, each once. A
/// factor `step` changes remodel_every and improve_every too, so that what lies between two of them
/// stays the same time as nearly as whole steps allow, unless they are factors of that run.
/// \throw InvalidInput if these are more than kMostRuns
std::vector<PlannedRun> plan(const Settings& own, const std::vector<Design>& designs);
inline constexpr std::size_t kMostRuns = 10000;  // more are surely a mistake

}  // namespace suture::sims
