// A scene: bodies, what moves them, the tracker's options, time, and what is written down.
#include "sims/scene/scene.h"

#include <fmt/format.h>
#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <limits>

#include "kernel/errors.h"
#include "kernel/files.h"
#include "kernel/measure/measures.h"
#include "kernel/shapes/shapes.h"
#include "kernel/shapes/transform.h"
#include "sims/flows/motions.h"
#include "sims/scene/bodies_reader.h"
#include "sims/scene/fluid_reader.h"
#include "sims/scene/option_tables.h"
#include "surgery/model/option_table.h"

namespace suture::sims {
namespace {

constexpr double kMostSteps = 1e8;  // beyond it a time step is surely a slip

/// The inner table of this name, or an empty one, so that its defaults are read the same way.
TomlTable table(const TomlTable& scene, const std::string& name) {
  const auto at = scene.tables.find(name);
  if (at != scene.tables.end()) {
    at->second.allow_tables({});
    return at->second;
  }
  if (scene.lists.count(name) != 0)
    scene.keys.refuse(name, "is a list of tables; write [" + name + "] once");
  return {Keys({}, name, scene.where), {}, {}, {}, scene.where};
}

/// Edges are subdivided until they are short enough, however many triangles that makes.
void require_affordable(const Scene& scene, const TomlTable& toml) {
  const QualityOptions& q = scene.tracker.quality;
  if (scene.time.improve_every == 0 || q.passes == 0) return;
  constexpr double usual = 1.5;  // what `longest` is if edges are to be about edge_length
  const bool own = q.edge_length > 0;
  const double finest = q.chord_error > 0 ? q.finest : 1;  // if it were curved everywhere
  const double edge = (own ? q.edge_length : scene.tracker.cell_size) * finest * q.longest / usual;
  // In units of the edge, whose square could be beyond the doubles; 4/√3 equilateral triangles
  // with edges of length 1 have an area of 1.
  const double factor =
      std::clamp(1 / edge, std::numeric_limits<double>::min(), std::numeric_limits<double>::max());
  const double triangles = 4 / std::sqrt(3.0) * area(scaled(scene.surface, factor));
  if (triangles <= kMostTriangles) return;
  table(toml, own ? "quality" : "tracker")
      .keys.refuse(own ? "edge_length" : "cell_size",
                   fmt::format("asks for edges of about {}, so for about {:.2g} triangles, more "
                               "than {}; give a larger one",
                               edge, triangles, kMostTriangles));
}

TimeOptions read_time(Keys keys) {
  const TimeOptions t = read_all(keys, time_options());
  if (!(t.end / t.step <= kMostSteps))
    keys.refuse("step", fmt::format("is {}, which asks for more than {} steps until {}", t.step,
                                    kMostSteps, t.end));
  return t;
}

/// Reads [pictures], and makes the picture's box and cut of what it says.
void read_pictures(const Keys& keys, OutputOptions& output) {
  output = read_all(keys, picture_options(), std::move(output));
  PictureOptions& p = output.picture;
  if (!(p.direction.cross(p.up).norm() > 1e-6 * p.direction.norm() * p.up.norm()))
    keys.refuse("direction", "and up must be two different directions");
  if (output.fit == Fit::box) {
    if (!(output.box.low.array() < output.box.high.array()).all())
      keys.refuse("fit", "is \"box\"; give its corners low and high, each of high above low");
    p.fit = output.box;
  }
  if (!output.cut_point && !output.cut_normal) return;
  const CutPlane usual;
  p.cut =
      CutPlane{output.cut_point.value_or(usual.point), output.cut_normal.value_or(usual.normal)};
  if (!(p.cut->normal.norm() > 0)) keys.refuse("cut_normal", "has no direction");
}

/// One motion, or several that take over from each other at the times `until`.
std::vector<Phase> read_phases(TomlTable& scene, const std::vector<Point>& velocities) {
  std::vector<TomlTable> tables;
  if (const auto list = scene.lists.find("motion"); list != scene.lists.end())
    tables = list->second;
  else
    tables.push_back(table(scene, "motion"));
  std::vector<Phase> phases;
  double from = 0;
  for (TomlTable& one : tables) {
    one.allow_tables({});
    Phase phase;
    phase.kind = std::get<std::string>(*one.keys.value(phase_options().row("kind").about));
    OptionInfo until = phase_options().row("until").about;
    until.range = Range::above(from);
    until.required = phases.size() + 1 < tables.size();
    if (const auto time = one.keys.value(until)) phase.until = option_values::number_in(*time);
    from = phase.until;
    phase.parameters = one.keys.values();
    try {
      phase.motion = make_motion(phase.kind, one.keys, velocities);
    } catch (const InvalidInput& error) {
      const std::string what = error.what();
      if (what.rfind(scene.where.substr(0, scene.where.rfind(':')), 0) == 0) throw;
      one.keys.refuse("kind", what);
    }
    phases.push_back(std::move(phase));
  }
  return phases;
}

/// Puts a value at "key" or "table.key" of a table, or of each table of a list of that name.
void put(TomlTable& table, const std::string& name, const Value& value) {
  const std::size_t dot = name.find('.');
  if (dot == std::string::npos) return table.keys.put(name, value, "a change of the scene");
  const std::string inner = name.substr(0, dot), rest = name.substr(dot + 1);
  if (const auto list = table.lists.find(inner); list != table.lists.end()) {
    for (TomlTable& each : list->second) put(each, rest, value);
    return;
  }
  const TomlTable empty{Keys({}, inner, table.where), {}, {}, {}, table.where};
  put(table.tables.emplace(inner, empty).first->second, rest, value);
}

void apply(const SceneChanges& changes, TomlTable& toml) {
  for (const auto& [name, value] : changes) put(toml, name, value);
}

}  // namespace

Scene read_scene(const std::filesystem::path& file, const SceneChanges& changes) {
  if (!std::filesystem::is_regular_file(file))
    throw InvalidInput(file.string() + ": there is no such file; give a scene's path");
  return parse_scene(read_file(file), file, {}, changes);
}

PictureOptions read_picture_options(const std::filesystem::path& file) {
  OutputOptions output;
  read_pictures(table(parse_toml(read_file(file), file), "pictures").keys, output);
  return output.picture;
}

namespace {

/// Reads the table of the fluid, or of the motions, that move the surface.
void read_movers(TomlTable& toml, const SceneSources& sources, Scene& scene) {
  scene.fluid = read_fluid(toml, scene.tracker, scene.file.parent_path(), sources, scene.notes);
  if (!scene.fluid) {
    scene.phases = read_phases(toml, scene.velocities);
    return;
  }
  if (toml.tables.count("motion") != 0 || toml.lists.count("motion") != 0)
    toml.keys.refuse("motion", "and [fluid] both move the surface; take one of them out");
}

}  // namespace

Scene parse_scene(const std::string& text, const std::filesystem::path& file,
                  const SceneSources& sources, const SceneChanges& changes) {
  TomlTable toml = parse_toml(text, file);
  toml.allow_tables({"bodies", "motion", "tracker", "quality", "method", "time", "meshes",
                     "pictures", "measure", "fluid", "solids"});
  apply(changes, toml);
  Scene scene;
  scene.file = file;
  scene.title = read_all(toml.keys, title_options(), {file.stem().string()}).title;
  scene.tracker = read_all(table(toml, "tracker").keys, tracker_options());
  scene.tracker.quality = read_all(table(toml, "quality").keys, quality_options());
  scene.method = read_method(table(toml, "method").keys, scene.tracker);
  scene.time = read_time(table(toml, "time").keys);
  scene.output = read_all(table(toml, "meshes").keys, mesh_options());
  read_pictures(table(toml, "pictures").keys, scene.output);
  scene.measure = read_all(table(toml, "measure").keys, measure_options());
  Bodies bodies = read_bodies(toml, file.parent_path(), sources);
  scene.surface = std::move(bodies.surface);
  scene.notes = std::move(bodies.notes);
  scene.shapes = std::move(bodies.shapes);
  scene.velocities = std::move(bodies.velocities);
  require_affordable(scene, toml);
  read_movers(toml, sources, scene);
  return scene;
}

}  // namespace suture::sims
