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
#include "sims/scene/option_tables.h"
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
