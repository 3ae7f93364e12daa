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
#include "sims/scene/option_names.h"

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

}  // namespace

QualityOptions read_quality(Keys keys) {
  QualityOptions q;
  q.edge_length = keys.number("edge_length", Range::at_least(0), q.edge_length);
  q.chord_error = keys.number("chord_error", Range::at_least(0), q.chord_error);
  q.finest = keys.number("finest", Range{0, 1, true}, q.finest);
  q.longest = keys.number("longest", Range::above(1), q.longest);
  q.shortest = keys.number("shortest", Range::between(0, 1), q.shortest);
  q.smallest_angle = keys.number("smallest_angle", Range::between(0, 60), q.smallest_angle);
  q.largest_angle = keys.number("largest_angle", Range::between(60, 180), q.largest_angle);
  q.feature_angle = keys.number("feature_angle", Range::between(0, 180), q.feature_angle);
  q.keep_features = keys.flag("keep_features", q.keep_features);
  q.volume_bound = keys.number("volume_bound", Range::at_least(0), q.volume_bound);
  q.turn_bound = keys.number("turn_bound", Range::between(0, 180), q.turn_bound);
  q.passes = static_cast<int>(keys.integer("passes", Range::between(0, 1000), q.passes));
  q.subdivision = keys.choice("subdivision", kSubdivisionNames, q.subdivision);
  keys.done();
  return q;
}

namespace {

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

}  // namespace

TrackerOptions read_tracker(Keys keys) {
  TrackerOptions t;
  t.cell_size = keys.number("cell_size", Range::above(0));
  t.origin = keys.vector("origin", t.origin);
  t.events = keys.choice("events", kEventsNames, t.events);
  t.cell_test = keys.choice("cell_test", kCellTestNames, t.cell_test);
  t.depth = static_cast<int>(keys.integer("depth", Range::between(0, 1000), t.depth));
  t.collapse = keys.choice("collapse", kCollapseNames, t.collapse);
  t.placement = keys.choice("placement", kPlacementNames, t.placement);
  t.arithmetic = keys.choice("arithmetic", kArithmeticNames, t.arithmetic);
  t.jitter = keys.number("jitter", Range::between(0, 0.1), t.jitter);
  t.most_restarts = static_cast<int>(keys.integer(
      "most_restarts", Range::between(0, std::numeric_limits<int>::max()), t.most_restarts));
  t.straighten_turn = keys.number("straighten_turn", Range::between(0, 180), t.straighten_turn);
  keys.done();
  return t;
}

namespace {

TimeOptions read_time(Keys keys) {
  TimeOptions t;
  t.step = keys.number("step", Range::above(0));
  t.end = keys.number("end", Range::at_least(0));
  const Range counts = Range::between(0, std::numeric_limits<int>::max());
  t.remodel_every = static_cast<int>(keys.integer("remodel_every", counts, t.remodel_every));
  t.improve_every = static_cast<int>(keys.integer("improve_every", counts, t.improve_every));
  if (!(t.end / t.step <= kMostSteps))
    keys.refuse("step", fmt::format("is {}, which asks for more than {} steps until {}", t.step,
                                    kMostSteps, t.end));
  keys.done();
  return t;
}

Every read_every(Keys& keys) {
  const Range counts = Range::between(0, std::numeric_limits<int>::max());
  return {static_cast<int>(keys.integer("every", counts, 0)), keys.list("at", Range::at_least(0))};
}

void read_meshes(Keys keys, OutputOptions& output) {
  output.meshes = read_every(keys);
  output.mesh_format = "ply";
  if (keys.has("format"))
    output.mesh_format = keys.one_of("format", {"obj", "off", "ply", "stl"});
  else
    keys.text("format", "");
  keys.done();
}

void read_camera(Keys& keys, OutputOptions& output) {
  constexpr std::array<Named<Fit>, 3> fits = {
      {{"first", Fit::first}, {"each", Fit::each}, {"box", Fit::box}}};
  PictureOptions& p = output.picture;
  p.direction = keys.vector("direction", p.direction);
  p.up = keys.vector("up", p.up);
  if (!(p.direction.cross(p.up).norm() > 1e-6 * p.direction.norm() * p.up.norm()))
    keys.refuse("direction", "and up must be two different directions");
  p.view_angle = keys.number("view_angle", Range::between(1, 120), p.view_angle);
  p.zoom = keys.number("zoom", Range::above(0), p.zoom);
  output.fit = keys.choice("fit", fits, output.fit);
  const Point low = keys.vector("low", Point::Zero()), high = keys.vector("high", Point::Zero());
  if (output.fit != Fit::box) return;
  if (!(low.array() < high.array()).all())
    keys.refuse("fit", "is \"box\"; give its corners low and high, each of high above low");
  p.fit = Box{low, high};
}

void read_pictures(Keys keys, OutputOptions& output) {
  constexpr std::array<Named<Colour>, 3> colours = {
      {{"plain", Colour::plain}, {"patches", Colour::patches}, {"components", Colour::components}}};
  output.pictures = read_every(keys);
  PictureOptions& p = output.picture;
  p.width = static_cast<int>(keys.integer("width", Range::between(16, 4096), p.width));
  p.height = static_cast<int>(keys.integer("height", Range::between(16, 4096), p.height));
  output.colour = keys.choice("colour", colours, output.colour);
  output.patch_fading = keys.number("patch_fading", Range::at_least(0), 0);
  p.edges = keys.flag("edges", p.edges);
  p.feature_angle = keys.number("feature_angle", Range::between(0, 180), p.feature_angle);
  read_camera(keys, output);
  if (keys.has("cut_point") || keys.has("cut_normal")) {
    CutPlane cut;
    cut.point = keys.vector("cut_point", cut.point);
    cut.normal = keys.vector("cut_normal", cut.normal);
    if (!(cut.normal.norm() > 0)) keys.refuse("cut_normal", "has no direction");
    p.cut = cut;
  } else {
    keys.vector("cut_point", Point::Zero());
    keys.vector("cut_normal", Point::Zero());
  }
  keys.done();
}

MeasureOptions read_measure(Keys keys) {
  MeasureOptions m;
  m.at = keys.list("at", Range::at_least(0));
  if (keys.has("reference"))
    m.reference = keys.one_of("reference", {"exact", "polyhedron", "none"});
  else
    keys.text("reference", "");
  m.domain = keys.number("domain", Range::at_least(0), m.domain);
  m.tolerance = keys.number("tolerance", Range::at_least(0), m.tolerance);
  const Range whole = Range::between(-1e9, 1e9);
  const auto components = static_cast<int>(keys.integer("components", whole, 0));
  const auto euler = static_cast<int>(keys.integer("euler", whole, 0));
  if (keys.has("components")) m.components = components;
  if (keys.has("euler")) m.euler = euler;
  m.until_components =
      static_cast<int>(keys.integer("until_components", Range::between(0, 1e9), 0));
  keys.done();
  return m;
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
    phase.kind = one.keys.one_of("kind", motion_names());
    const bool last = phases.size() + 1 == tables.size();
    phase.until = last && !one.keys.has("until") ? std::numeric_limits<double>::infinity()
                                                 : one.keys.number("until", Range::above(from));
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

std::int64_t TimeOptions::steps() const {
  // A quotient that rounding left just above a whole number is that number.
  constexpr double rounding = 1e-9;
  return static_cast<std::int64_t>(std::ceil(end / step * (1 - rounding)));
}

bool Every::wants(std::int64_t index, const TimeOptions& time) const {
  if (!any()) return false;
  if (index == 0 || index == time.steps()) return true;
  if (steps > 0 && index % steps == 0) return true;
  const double now = static_cast<double>(index) * time.step;
  for (const double t : at)
    if (std::abs(t - now) < 0.5 * time.step) return true;
  return false;
}

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

/// What moves the surface: a fluid, or motions.
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
  scene.title = toml.keys.text("title", file.stem().string());
  toml.keys.done();
  scene.tracker = read_tracker(table(toml, "tracker").keys);
  scene.tracker.quality = read_quality(table(toml, "quality").keys);
  scene.method = read_method(table(toml, "method").keys, scene.tracker);
  scene.time = read_time(table(toml, "time").keys);
  read_meshes(table(toml, "meshes").keys, scene.output);
  read_pictures(table(toml, "pictures").keys, scene.output);
  scene.measure = read_measure(table(toml, "measure").keys);
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
