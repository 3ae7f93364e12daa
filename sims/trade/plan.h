// Which runs a study makes of a scene: factors, their levels, and the designs that combine them.
#pragma once

#include "sims/trade/settings.h"

namespace suture {

/// One level of a factor: a value, or a multiple of what the scene has.
struct Level {
  Value value;
  bool multiple = false;
};

/// What is varied: a setting, or `resolution`, the cell size and the edge length together.
struct Factor {
  std::string name;
  std::vector<std::string> settings;  ///< full names
  std::vector<Level> levels;
};

/// Reads "cell_size=x0.5,0.05": multiples of the scene's own are written with an x.
/// \throw InvalidInput for an unknown factor, no levels, or a multiple of what is no number
Factor read_factor(const std::string& text, const Settings& own);

/// What is varied where the user does not say, in that notation: one at a time, and as a grid.
std::vector<std::string> default_spokes(const Settings& own);
std::vector<std::string> default_grid();

struct PlannedRun {
  SceneChanges changes;  ///< only what differs from the scene
  std::string design;    ///< "own", "grid", or the name of the one factor that is varied
};

/// x to six digits, as a person would write it.
double rounded_for_people(double x);

/// The scene's own run, each level of the spokes alone, and the product of the grid; each once. A
/// factor `step` changes remodel_every and improve_every too, so that what lies between two of them
/// stays the same time as nearly as whole steps allow, unless they are factors of that run.
/// \throw InvalidInput if these are more than kMostRuns
std::vector<PlannedRun> plan(const Settings& own, const std::vector<Factor>& spokes,
                             const std::vector<Factor>& grid);
inline constexpr std::size_t kMostRuns = 10000;  // beyond it a product of levels is surely a slip

}  // namespace suture
