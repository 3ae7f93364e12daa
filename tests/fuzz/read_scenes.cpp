// The scene parser, without a file system: refused by InvalidInput, or a scene that can be run.
#include <algorithm>
#include <cmath>

#include "kernel/audit.h"
#include "kernel/errors.h"
#include "sims/scene/scene.h"
#include "tests/fuzz/targets.h"
#include "tests/kernel/tiny.h"

namespace suture::fuzz {

using namespace suture::sims;

namespace {

constexpr double kMostPartsALength = 4;  // edges along a shape's lengths: some 500 triangles
constexpr double kMostTrianglesHere = 20'000;

void require(bool holds, const std::string& what) {
  if (!holds) throw Finding("scene: " + what);
}

/// Whether the shape's area, and so its resolution, follows from any one of its lengths: then far
/// too short edges are surely refused.
bool round_all_over(const std::string& shape) {
  return shape != "box" && shape != "sheet" && shape != "cylinder" && shape != "torus";
}

/// The shape as it is asked for, but with fewer triangles where the parameters ask for many that
/// could still be held: the parser does not know, and the fuzzer has the time for more scenes.
Triangles coarse_shape(const std::string& name, std::map<std::string, double> parameters) {
  constexpr double kFarTooMany = 1e5;
  const auto at = std::find_if(shape_catalogue().begin(), shape_catalogue().end(),
                               [&](const ShapeInfo& s) { return s.name == name; });
  if (at == shape_catalogue().end()) return make_shape(name, parameters);
  double longest = 0, edge = 0;
  for (const ShapeParameter& p : at->parameters) {
    const auto given = parameters.find(p.name);
    const double value = given == parameters.end() ? p.value : given->second;
    if (p.name == "edge_length")
      edge = value;
    else if (p.unit == "length" && p.name.size() > 1)  // not a coordinate of the centre
      longest = std::max(longest, std::abs(value));
  }
  const double parts = longest / edge;
  if (parts > kMostPartsALength && (parts < kFarTooMany || !round_all_over(name)))
    parameters["edge_length"] = longest / kMostPartsALength;
  if (const auto f = parameters.find("frequency"); f != parameters.end())
    if (f->second > kMostPartsALength && f->second < kFarTooMany / 50)
      f->second = kMostPartsALength;
  return make_shape(name, parameters);
}

/// Two files are there: a good mesh and one that is open.
Triangles read_mesh(const std::filesystem::path& file) {
  const std::string name = file.filename().string();
  if (name == "body.ply") return tetrahedron();
  if (name == "open.ply") return sheet(1);
  throw InvalidInput(file.string() + ": there is no such file");
}

SceneSources sources() {
  SceneSources s;
  s.is_file = [](const std::filesystem::path& p) { return p.filename() == "body.ply"; };
  s.read_mesh = read_mesh;
  s.make_shape = coarse_shape;
  s.most_triangles = kMostTrianglesHere;
  return s;
}

void require_runnable(const Scene& scene) {
  const Audit found = audit(scene.surface);
  require(found.closed_manifold(), "a body that is no closed manifold was accepted");
  require(static_cast<double>(scene.surface.triangles.size()) <= kMostTrianglesHere,
          "more triangles were made than are allowed");
  require(!scene.phases.empty() && scene.phases.back().motion != nullptr, "nothing moves");
  require(scene.tracker.cell_size > 0 && std::isfinite(scene.tracker.cell_size), "no cell size");
  require(scene.time.steps() >= 0 && scene.time.step > 0, "time does not pass");
}

}  // namespace

void read_scene_text(std::string_view bytes) {
  try {
    require_runnable(parse_scene(std::string(bytes), "scenes/fuzzed.toml", sources()));
  } catch (const InvalidInput& refusal) {
    const std::string said = refusal.what();
    require(said.starts_with("scenes/"), "a refusal does not name the file: " + said);
  }
}

}  // namespace suture::fuzz
