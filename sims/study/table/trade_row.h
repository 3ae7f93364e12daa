// The columns of a trade study's table, and what a row of it says.
#pragma once

#include <array>
#include <utility>

#include "sims/study/table/table.h"

namespace suture::sims {

/// The numbers that are known of a run. Lengths are in the scene's unit; "forth" is from the result
/// to the reference, "back" from the reference to the result. `volume_error` is volume ÷ the
/// reference's − 1, `volume_drift` the same against the first surface. `topology_right` is 1 where
/// components and Euler characteristic are as in the reference, else 0. The least angle is in
/// degrees. Seconds are CPU; the tracker's are those of remodels and improvements. `seconds_spread`
/// is that of tracker_seconds over the repeats: (most − least) ÷ median.
inline constexpr std::array<const char*, 26> kFigures = {"mean_distance_forth",
                                                         "mean_distance_back",
                                                         "max_distance_forth",
                                                         "max_distance_back",
                                                         "volume_error",
                                                         "volume_drift",
                                                         "components",
                                                         "euler",
                                                         "topology_right",
                                                         "self_intersecting_pairs",
                                                         "triangles_without_area",
                                                         "least_angle",
                                                         "tracker_seconds",
                                                         "remodel_seconds",
                                                         "improve_seconds",
                                                         "move_seconds",
                                                         "total_seconds",
                                                         "seconds_spread",
                                                         "peak_megabytes",
                                                         "triangles_mean",
                                                         "triangles_max",
                                                         "triangles_end",
                                                         "steps",
                                                         "remodels",
                                                         "surgeries",
                                                         "refused"};

/// The settings of a run by their keys, as texts.
using SettingTexts = std::vector<std::pair<std::string, std::string>>;

/// A row with every column of the table. `run` is a number that names it in plots and words,
/// `design` as PlannedRun has it, `change` what differs from the scene, in words; the settings; how
/// the run ended and, if not well, why; the figures; `surface`, the fingerprint of its last
/// surface; `repeats`, the processes whose medians its costs are; `study`, the fingerprint of scene
/// and reference: rows of two do not mix. All but the settings are empty.
Row trade_row(const SettingTexts& settings);

/// The settings that a row has.
SettingTexts setting_texts(const Row& row);

/// \throw InvalidInput with file and line for what is no table of a trade study
std::vector<Row> read_trade_table(const std::filesystem::path& file);

/// \return whether the run did not end, or surgeries were refused
bool failed(const Row& row);

/// \return whether the run may be compared by its errors: it got to its end, with the reference's
/// topology
bool sound(const Row& row);

/// The mean of both ways, and the larger of both.
double mean_distance(const Row& row);
double max_distance(const Row& row);

/// CPU seconds of remodels and improvements.
double tracker_seconds(const Row& row);

/// The size of the volume's error.
double volume_error(const Row& row);

/// The run's number.
int run_number(const Row& row);

}  // namespace suture::sims
