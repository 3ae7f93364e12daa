// A scene: bodies, what moves them, the tracker's options, time, and what is written down.
#pragma once

#include <filesystem>
#include <limits>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "sims/baselines/method.h"
#include "sims/flows/motion.h"
#include "sims/output/picture.h"
#include "sims/scene/placed_shape.h"
#include "sims/scene/scene_sources.h"
#include "surgery/model/options.h"

namespace suture::sims {

struct FluidOptions;

/// A motion and the time at which the next one takes over.
struct Phase {
  std::string kind;
  std::map<std::string, Value> parameters;  ///< as given
  double until = std::numeric_limits<double>::infinity();
  std::unique_ptr<Motion> motion;
};

struct TimeOptions {
  double step = 0;  ///< dt
  double end = 0;
  int remodel_every = 1;       ///< steps; 0: never
  int improve_every = 1;       ///< steps; 0: never
  std::int64_t steps() const;  ///< the least number of whole steps that reaches `end`
};

/// Which steps are written; the first and the last always are, where any is.
struct Every {
  int steps = 0;           ///< 0: none but those in `at`
  std::vector<double> at;  ///< times
  bool wants(std::int64_t step, const TimeOptions& time) const;
  bool any() const { return steps > 0 || !at.empty(); }
};

/// What the camera keeps in view.
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

/// What `suture measure` is to look at, and what is right.
struct MeasureOptions {
  std::vector<double> at;                ///< times; empty: the end
  std::string reference = "exact";       ///< "exact", "polyhedron", "none"
  double tolerance = 0;                  ///< of an exact reference; 0: a thousandth of a cell
  std::optional<int> components, euler;  ///< none: as the first surface has them
  double domain = 0;                     ///< its side, for the table; 0: none is known
  int until_components = 0;              ///< the run ends where no more are left; 0: at its end
};

struct Scene {
  std::filesystem::path file;
  std::string title;
  Triangles surface;                          ///< the union of the bodies, one after another
  std::vector<PlacedShape> shapes;            ///< the bodies themselves
  std::vector<std::string> notes;             ///< what was done to get there: fallbacks and repairs
  std::vector<Phase> phases;                  ///< empty where a fluid moves the surface
  std::shared_ptr<const FluidOptions> fluid;  ///< null: none
  std::vector<Point> velocities;              ///< of the surface's vertices, as their bodies begin
  TrackerOptions tracker;
  MethodOptions method;
  TimeOptions time;
  OutputOptions output;
  MeasureOptions measure;
};

/// Values in place of a scene file's own, by table and key: "tracker.cell_size"; of a list of
/// tables, as "bodies.scatter_seed" or "bodies.parameters.radius", in each of them.
using SceneChanges = std::map<std::string, Value>;

/// Reads a scene from a TOML file, and its meshes from paths relative to that file. Models are
/// looked for in $SUTURE_MODELS and in data/models beside the folder of the scene. `changes` are
/// read, and refused, as if they stood in the file.
/// \throw InvalidInput with file, line, key and what is allowed, for anything unknown, of a wrong
/// type, out of range, or missing; and for a body that is not a closed oriented manifold
Scene read_scene(const std::filesystem::path& file, const SceneChanges& changes = {});

/// The [pictures] table of a scene file; its bodies and the rest are not looked at.
/// \throw InvalidInput as read_scene
PictureOptions read_picture_options(const std::filesystem::path& file);

/// The options of a table in a file, which may hold nothing else. \throw InvalidInput likewise
template <class Options>
Options read_all(Keys keys, const OptionTable<Options>& table, Options options = {}) {
  read(keys, table, options);
  keys.done();
  return options;
}

/// The scene in a text, as if it stood in `file`, which need not be there. \throw as read_scene
Scene parse_scene(const std::string& text, const std::filesystem::path& file,
                  const SceneSources& sources = {}, const SceneChanges& changes = {});

}  // namespace suture::sims
