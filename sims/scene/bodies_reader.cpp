// A scene's bodies: shapes and mesh files, repaired where asked, placed, and checked.
#include "sims/scene/bodies_reader.h"

#include <fmt/format.h>

#include <cmath>
#include <cstdlib>
#include <numbers>

#include "kernel/audit.h"
#include "kernel/errors.h"
#include "kernel/formats/mesh_io.h"
#include "kernel/lattice.h"
#include "kernel/random.h"
#include "kernel/repair/repair.h"
#include "kernel/shapes/transform.h"

namespace suture::sims {
namespace {

namespace fs = std::filesystem;

constexpr double kMostCopies = 1e6;  // beyond it a count is surely a slip

/// Where a model of this name is: in $SUTURE_MODELS, or in data/models seen from the scene's
/// folder.
fs::path find_model(const std::string& name, const fs::path& folder, const SceneSources& sources) {
  std::vector<fs::path> places;
  if (const char* chosen = std::getenv("SUTURE_MODELS")) places.emplace_back(chosen);
  places.push_back(folder / "models");
  places.push_back(folder / ".." / "models");
  places.push_back("data/models");
  for (const fs::path& place : places)
    for (const std::string_view extension : kMeshExtensions)
      if (const fs::path file = place / (name + std::string(extension)); sources.is_file(file))
        return file;
  return {};
}

std::map<std::string, double> shape_parameters(TomlTable& body) {
  std::map<std::string, double> values;
  const auto at = body.tables.find("parameters");
  if (at == body.tables.end()) return values;
  at->second.allow_tables({});
  for (const std::string& key : at->second.keys.names())
    values[key] = at->second.keys.number(key, Range::any());
  return values;
}

Triangles shape(const std::string& key, TomlTable& body, const SceneSources& sources) {
  Keys& keys = body.keys;
  const std::string name = keys.text(key);
  try {
    return sources.make_shape(name, shape_parameters(body));
  } catch (const InvalidInput& error) {
    keys.refuse(key, error.what());
  }
}

/// Turned by `degrees` about the axis that the key `about` gives, z by default.
Triangles turned(Triangles surface, Keys& keys, const std::string& about, double degrees) {
  const Point axis = keys.vector(about, Point::UnitZ());
  const double length = axis.stableNorm();
  if (!(length > 0 && std::isfinite(length)))
    keys.refuse(about, "has no direction, or is too long; give one such as [0, 0, 1]");
  return rotated(std::move(surface), axis, degrees * (std::numbers::pi / 180));
}

struct Source {
  Triangles surface;
  std::string name;
  std::map<std::string, double> parameters{};
};

Source read_source(TomlTable& body, const fs::path& folder, const SceneSources& sources,
                   std::vector<std::string>& notes) {
  Keys& keys = body.keys;
  const bool is_mesh = keys.has("mesh"), is_model = keys.has("model"), is_shape = keys.has("shape");
  if (is_mesh + is_model + is_shape != 1)
    keys.refuse("shape", "give one of shape, mesh (a file) or model (a name), and only one");
  if (is_shape) return {shape("shape", body, sources), keys.text("shape"), shape_parameters(body)};
  if (is_mesh) {
    const fs::path file = folder / keys.text("mesh");
    return {sources.read_mesh(file), file.string()};
  }
  const std::string name = keys.text("model");
  const fs::path file = find_model(name, folder, sources);
  if (!file.empty()) return {sources.read_mesh(file), file.string()};
  if (!keys.has("fallback"))
    keys.refuse("model", "is \"" + name +
                             "\", which is not in $SUTURE_MODELS nor in data/models; bring it "
                             "there, or name a shape as fallback");
  notes.push_back("the model " + name + " is not here: the shape " + keys.text("fallback") +
                  " takes its place");
  const double degrees = keys.number("fallback_rotate", Range::any(), 0);
  return {turned(shape("fallback", body, sources), keys, "fallback_rotate_axis", degrees),
          keys.text("fallback")};
}

/// So that scenes can count on a model's place and size, whatever a scanner's unit was.
Triangles normalised(const Triangles& surface) {
  const Box box = bounding_box(surface.positions);
  const double longest = (box.high - box.low).maxCoeff();
  if (!(longest > 0)) return surface;
  return scaled(translated(surface, -(box.low + box.high) / 2), 1 / longest);
}

/// Scales, turns and moves the surface; \return what it now is.
PlacedShape place(Source& source, Keys& keys) {
  Triangles& surface = source.surface;
  PlacedShape is;
  const bool as_made = !keys.flag("normalise", false);
  if (!as_made) surface = normalised(surface);
  if (as_made && keys.has("shape") && !keys.flag("repair", false)) {
    is.shape = source.name;
    is.parameters = source.parameters;
  }
  is.scale = keys.number("scale", Range::above(0), 1);
  surface = scaled(surface, is.scale);
  const double degrees = keys.number("rotate", Range::any(), 0);
  surface = turned(std::move(surface), keys, "rotate_axis", degrees);
  const Triangles axes{{Point::UnitX(), Point::UnitY(), Point::UnitZ()}, {}};
  const Triangles turned_axes = turned(axes, keys, "rotate_axis", degrees);
  for (int i = 0; i < 3; ++i) is.turn.col(i) = turned_axes.positions[i];
  is.move = keys.vector("translate", Point::Zero());
  surface = translated(surface, is.move);
  is.vertices = surface.positions.size();
  is.triangles = surface.triangles.size();
  return is;
}

/// How many of the body there are; with those before, no more than can be held.
std::int64_t read_copies(Keys& keys, std::size_t triangles, std::size_t before, double most) {
  const std::int64_t copies = keys.integer("copies", Range::between(1, kMostCopies), 1);
  const double total =
      static_cast<double>(triangles) * static_cast<double>(copies) + static_cast<double>(before);
  if (!(total <= most))
    keys.refuse("copies", fmt::format("is {}, of {} triangles each: {} with the bodies before, "
                                      "more than {}; give fewer copies, or longer edges",
                                      copies, triangles, total, most));
  return copies;
}

/// Where the copies of a body go: one as it is, or many at seeded random places in a box.
std::vector<Point> scattered(Keys& keys, std::int64_t copies) {
  const std::int64_t seed = keys.integer("scatter_seed", Range::at_least(0), 1);
  const Point low = keys.vector("scatter_low", Point::Zero());
  const Point high = keys.vector("scatter_high", low);
  Random random(static_cast<std::uint64_t>(seed));
  std::vector<Point> places;
  for (std::int64_t i = 0; i < copies; ++i) {
    Point place;
    for (int axis = 0; axis < 3; ++axis) place[axis] = random.uniform(low[axis], high[axis]);
    if (!place.allFinite()) keys.refuse("scatter_high", "is too far from scatter_low");
    places.push_back(place);
  }
  return places;
}

void read_body(TomlTable& body, const fs::path& folder, const SceneSources& sources,
               Bodies& bodies) {
  Keys& keys = body.keys;
  const auto [surface, is] = read_placed(body, folder, sources, bodies.notes);
  const Point velocity = keys.vector("velocity", Point::Zero());
  const std::int64_t copies = read_copies(keys, surface.triangles.size(),
                                          bodies.surface.triangles.size(), sources.most_triangles);
  const std::vector<Point> places = scattered(keys, copies);
  keys.done();
  std::vector<Triangles> all = {std::move(bodies.surface)};
  for (const Point& at : places) {
    all.push_back(translated(surface, at));
    bodies.shapes.push_back(is);
    bodies.shapes.back().move += at;
  }
  bodies.surface = merged(all);
  for (const Point& p : bodies.surface.positions)
    if (!p.allFinite())
      keys.refuse("translate", "scale and scatter take the body beyond what a double can hold");
  bodies.velocities.resize(bodies.surface.positions.size(), velocity);
}

}  // namespace

PlacedSurface read_placed(TomlTable& body, const fs::path& folder, const SceneSources& sources,
                          std::vector<std::string>& notes) {
  body.allow_tables({"parameters"});
  Keys& keys = body.keys;
  Source source = read_source(body, folder, sources, notes);
  if (keys.flag("repair", false)) {
    for (const std::string& done : repair(source.surface).in_words())
      notes.push_back(source.name + ": " + done);
  }
  keys.text("fallback", "");  // known, and of no use where the model is there
  keys.number("fallback_rotate", Range::any(), 0);
  keys.vector("fallback_rotate_axis", Point::UnitZ());
  require_usable(source.surface, body.where + ": " + source.name);
  const PlacedShape is = place(source, keys);
  return {std::move(source.surface), is};
}

Bodies read_bodies(TomlTable& scene, const fs::path& folder, const SceneSources& sources) {
  const auto list = scene.lists.find("bodies");
  if (list == scene.lists.end())
    scene.keys.refuse("bodies", "is missing; give at least one [[bodies]]");
  Bodies bodies;
  for (TomlTable& body : list->second) read_body(body, folder, sources, bodies);
  return bodies;
}

}  // namespace suture::sims
