// What a scene says of its bodies, of time, of what is written and what is measured, as options.
#pragma once

#include "kernel/option_table.h"
#include "sims/output/picture.h"

namespace suture::sims {

struct TitleOptions {
  std::string title;
};

struct TimeOptions {
  double step = 0;  ///< dt
  double end = 0;
  int remodel_every = 1;       ///< steps; 0: never
  int improve_every = 1;       ///< steps; 0: never
  std::int64_t steps() const;  ///< the least number of whole steps that reaches `end`
};

/// The steps that are written. The first and the last always are, where any is.
struct Every {
  int steps = 0;           ///< 0: none but those in `at`
  std::vector<double> at;  ///< times
  bool wants(std::int64_t step, const TimeOptions& time) const;
  bool any() const { return steps > 0 || !at.empty(); }
};

/// The part of the scene that the camera keeps in view.
enum class Fit { first, each, box };

struct OutputOptions {
  std::string mesh_format = "ply";  ///< or "obj", "off", "stl"
  Every meshes, pictures;
  Colour colour = Colour::patches;
  double patch_fading = 0;  ///< time in which a patch's colour fades; 0: a tenth of the whole
  Fit fit = Fit::first;
  Box box;                                     ///< with Fit::box only: what is in view
  std::optional<Point> cut_point, cut_normal;  ///< neither: nothing is cut away
  PictureOptions picture;                      ///< with its box and cut as the fields above say
};

/// The times and things that `suture measure` looks at, and the right answers.
struct MeasureOptions {
  std::vector<double> at;                ///< times; empty: the end
  std::string reference = "exact";       ///< "exact", "polyhedron", "none"
  double tolerance = 0;                  ///< of an exact reference; 0: a thousandth of a cell
  std::optional<int> components, euler;  ///< none: as the first surface has them
  double domain = 0;                     ///< its side, for the table; 0: none is known
  int until_components = 0;              ///< the run ends where no more are left; 0: at its end
};

/// The source of the surface of a body or a solid, and its place.
struct PlacedOptions {
  std::optional<std::string> shape, mesh, model;  ///< one of them
  std::optional<std::string> fallback;            ///< the shape where there is no such model
  double fallback_rotate = 0;                     ///< degrees
  Point fallback_rotate_axis = Point::UnitZ();
  bool repair = false, normalise = false;
  double scale = 1, rotate = 0;  ///< a factor, and degrees
  Point rotate_axis = Point::UnitZ(), translate = Point::Zero();
};

/// How often a body is there, and how fast it is.
struct BodyOptions {
  Point velocity = Point::Zero();
  std::int64_t copies = 1;
  std::int64_t scatter_seed = 1;
  Point scatter_low = Point::Zero();
  std::optional<Point> scatter_high;  ///< none: scatter_low
};

/// The kind of a motion, and the time at which the next one takes over.
struct PhaseOptions {
  std::string kind;
  double until = std::numeric_limits<double>::infinity();
};

const OptionTable<TitleOptions>& title_options();
const OptionTable<TimeOptions>& time_options();
const OptionTable<OutputOptions>& mesh_options();
const OptionTable<OutputOptions>& picture_options();
const OptionTable<MeasureOptions>& measure_options();

/// [[motion]]: each kind has options of its own besides.
const OptionTable<PhaseOptions>& phase_options();

/// [[bodies]]: where a surface comes from and is placed, and how often it is there. A solid of the
/// kind `mesh` has the first as well.
const OptionTable<PlacedOptions>& placed_options();
const OptionTable<BodyOptions>& body_options();

}  // namespace suture::sims
