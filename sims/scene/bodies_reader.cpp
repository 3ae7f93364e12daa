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
#include "sims/scene/option_tables.h"

namespace suture::sims {
namespace {

namespace fs = std::filesystem;

/// Finds the model of this name in $SUTURE_MODELS, or in data/models seen from the scene's
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

/// The shape that the text of `key` names.
Triangles shape(const char* key, const std::string& name, TomlTable& body,
                const SceneSources& sources) {
  try {
    return sources.make_shape(name, shape_parameters(body));
  } catch (const InvalidInput& error) {
    body.keys.refuse(key, error.what());
  }
}

struct Turn {
  double degrees;
  const Point& axis;
  const char* key;  ///< that of the axis
};

Triangles turned(Triangles surface, const Turn& turn, const Keys& keys) {
  const double length = turn.axis.stableNorm();
  if (!(length > 0 && std::isfinite(length)))
    keys.refuse(turn.key, "has no direction, or is too long; give one such as [0, 0, 1]");
  return rotated(std::move(surface), turn.axis, turn.degrees * (std::numbers::pi / 180));
}

/// The sources of files and shapes, and the notes for the user.
struct Surroundings {
  const fs::path& folder;
  const SceneSources& sources;
  std::vector<std::string>& notes;
};

struct Source {
  Triangles surface;
  std::string name;
  std::map<std::string, double> parameters{};
};

/// The fallback of a model that is not there.
Source read_fallback(const PlacedOptions& o, TomlTable& body, const Surroundings& from) {
  if (!o.fallback)
    body.keys.refuse("model", "is \"" + *o.model +
                                  "\", which is not in $SUTURE_MODELS nor in data/models; bring it "
                                  "there, or name a shape as fallback");
  from.notes.push_back("the model " + *o.model + " is not here: the shape " + *o.fallback +
                       " takes its place");
  const Turn turn{o.fallback_rotate, o.fallback_rotate_axis, "fallback_rotate_axis"};
  return {turned(shape("fallback", *o.fallback, body, from.sources), turn, body.keys), *o.fallback};
}

Source read_source(const PlacedOptions& o, TomlTable& body, const Surroundings& from) {
  if (o.mesh.has_value() + o.model.has_value() + o.shape.has_value() != 1)
    body.keys.refuse("shape", "give one of shape, mesh (a file) or model (a name), and only one");
  if (o.shape)
    return {shape("shape", *o.shape, body, from.sources), *o.shape, shape_parameters(body)};
  const fs::path file =
      o.mesh ? from.folder / *o.mesh : find_model(*o.model, from.folder, from.sources);
  if (!o.mesh && file.empty()) return read_fallback(o, body, from);
  return {from.sources.read_mesh(file), file.string()};
}

/// Scenes can count on the place and size of a model so made, whatever a scanner's unit was.
Triangles normalised(const Triangles& surface) {
  const Box box = bounding_box(surface.positions);
  const double longest = (box.high - box.low).maxCoeff();
  if (!(longest > 0)) return surface;
  return scaled(translated(surface, -(box.low + box.high) / 2), 1 / longest);
}

/// Scales, turns and moves the surface; \return what it now is.
PlacedShape place(Source& source, const PlacedOptions& o, const Keys& keys) {
  Triangles& surface = source.surface;
  PlacedShape is;
  if (o.normalise) surface = normalised(surface);
  if (!o.normalise && o.shape && !o.repair) {
    is.shape = source.name;
    is.parameters = source.parameters;
  }
  is.scale = o.scale;
  surface = scaled(surface, is.scale);
  const Turn turn{o.rotate, o.rotate_axis, "rotate_axis"};
  surface = turned(std::move(surface), turn, keys);
  const Triangles axes{{Point::UnitX(), Point::UnitY(), Point::UnitZ()}, {}};
  const Triangles turned_axes = turned(axes, turn, keys);
  for (int i = 0; i < 3; ++i) is.turn.col(i) = turned_axes.positions[i];
  is.move = o.translate;
  surface = translated(surface, is.move);
  is.vertices = surface.positions.size();
  is.triangles = surface.triangles.size();
  return is;
}

/// The places of a body's copies: one as it is, or many at seeded random places in a box.
std::vector<Point> scattered(const BodyOptions& o, const Keys& keys) {
  const Point low = o.scatter_low, high = o.scatter_high.value_or(low);
  Random random(static_cast<std::uint64_t>(o.scatter_seed));
  std::vector<Point> places;
  for (std::int64_t i = 0; i < o.copies; ++i) {
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
  BodyOptions o;
  read(keys, body_options(), o);
  const std::size_t each = surface.triangles.size();
  const double total = static_cast<double>(each) * static_cast<double>(o.copies) +
                       static_cast<double>(bodies.surface.triangles.size());
  if (!(total <= sources.most_triangles))
    keys.refuse("copies", fmt::format("is {}, of {} triangles each: {} with the bodies before, "
                                      "more than {}; give fewer copies, or longer edges",
                                      o.copies, each, total, sources.most_triangles));
  const std::vector<Point> places = scattered(o, keys);
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
  bodies.velocities.resize(bodies.surface.positions.size(), o.velocity);
}

}  // namespace

PlacedSurface read_placed(TomlTable& body, const fs::path& folder, const SceneSources& sources,
                          std::vector<std::string>& notes) {
  body.allow_tables({"parameters"});
  PlacedOptions o;
  read(body.keys, placed_options(), o);
  Source source = read_source(o, body, {folder, sources, notes});
  if (o.repair) {
    for (const std::string& done : repair(source.surface).in_words())
      notes.push_back(source.name + ": " + done);
  }
  require_usable(source.surface, body.where + ": " + source.name);
  const PlacedShape is = place(source, o, body.keys);
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
