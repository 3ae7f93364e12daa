// What is known of one run of a study: its settings, how it ended, and every measure.
#pragma once

#include <array>
#include <limits>
#include <string>
#include <vector>

#include "sims/study/settings.h"

namespace suture::sims {

inline constexpr double kUnknownFigure = std::numeric_limits<double>::quiet_NaN();

/// The figures of a run; those that it did not reach are NaN. Lengths are in the scene's unit,
/// "forth" is from the result to the reference and "back" from the reference to the result.
struct Figures {
  double mean_forth = kUnknownFigure, mean_back = kUnknownFigure;
  double max_forth = kUnknownFigure, max_back = kUnknownFigure;
  double volume_error = kUnknownFigure;  ///< volume / the reference's − 1
  double volume_drift = kUnknownFigure;  ///< volume / the first surface's − 1
  double components = kUnknownFigure, euler = kUnknownFigure;
  double topology_right = kUnknownFigure;  ///< 1: components and Euler characteristic as in the
                                           ///< reference, 0: not
  double intersecting_pairs = kUnknownFigure, without_area = kUnknownFigure;
  double least_angle = kUnknownFigure;  ///< degrees
  double tracker_seconds = kUnknownFigure, remodel_seconds = kUnknownFigure,
         improve_seconds = kUnknownFigure, move_seconds = kUnknownFigure,
         total_seconds = kUnknownFigure;  ///< CPU; the tracker's are remodel and improve
  double spread = kUnknownFigure;  ///< of tracker_seconds over the repeats: (most − least) / median
  double peak_megabytes = kUnknownFigure;
  double triangles_mean = kUnknownFigure, triangles_max = kUnknownFigure,
         triangles_end = kUnknownFigure;
  double steps = kUnknownFigure, remodels = kUnknownFigure, surgeries = kUnknownFigure,
         refused = kUnknownFigure;

  double mean_distance() const { return (mean_forth + mean_back) / 2; }
  double max_distance() const { return max_forth > max_back ? max_forth : max_back; }
};

struct NamedFigure {
  const char* name;
  double Figures::*figure;
};
/// Each figure by its column's name, in the table's order.
inline constexpr std::array<NamedFigure, 26> kFigures = {
    {{"mean_distance_forth", &Figures::mean_forth},
     {"mean_distance_back", &Figures::mean_back},
     {"max_distance_forth", &Figures::max_forth},
     {"max_distance_back", &Figures::max_back},
     {"volume_error", &Figures::volume_error},
     {"volume_drift", &Figures::volume_drift},
     {"components", &Figures::components},
     {"euler", &Figures::euler},
     {"topology_right", &Figures::topology_right},
     {"self_intersecting_pairs", &Figures::intersecting_pairs},
     {"triangles_without_area", &Figures::without_area},
     {"least_angle", &Figures::least_angle},
     {"tracker_seconds", &Figures::tracker_seconds},
     {"remodel_seconds", &Figures::remodel_seconds},
     {"improve_seconds", &Figures::improve_seconds},
     {"move_seconds", &Figures::move_seconds},
     {"total_seconds", &Figures::total_seconds},
     {"seconds_spread", &Figures::spread},
     {"peak_megabytes", &Figures::peak_megabytes},
     {"triangles_mean", &Figures::triangles_mean},
     {"triangles_max", &Figures::triangles_max},
     {"triangles_end", &Figures::triangles_end},
     {"steps", &Figures::steps},
     {"remodels", &Figures::remodels},
     {"surgeries", &Figures::surgeries},
     {"refused", &Figures::refused}}};

/// How a run ended, in the table's words.
inline constexpr const char* kDoneRun = "done";        ///< to its end, every surgery committed
inline constexpr const char* kRefusedRun = "refused";  ///< to its end, but surgeries were refused
inline constexpr const char* kStoppedRun = "stopped";  ///< Suture said why it cannot go on
inline constexpr const char* kCrashedRun = "crashed";  ///< killed by a signal
inline constexpr const char* kTimedOutRun = "timed_out";

struct Row {
  int run = 0;         ///< a number that names it in plots and words
  std::string study;   ///< fingerprint of scene and reference: rows of two do not mix
  std::string design;  ///< as PlannedRun has it
  std::string change;  ///< what differs from the scene, in words
  std::vector<std::pair<std::string, std::string>> settings;  ///< all of them, key and text
  std::string outcome, failure;
  Figures figures;
  std::string surface;  ///< fingerprint of the last surface's bits
  int repeats = 0;      ///< processes whose medians the seconds and memory are

  bool failed() const { return outcome != kDoneRun; }
  /// Whether it may be compared by its errors: to its end, with the reference's topology.
  bool sound() const { return !failed() && figures.topology_right == 1; }
};

}  // namespace suture::sims
