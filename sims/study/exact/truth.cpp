// The surface that a scene should have at a time, kept on disk once it was computed.
#include "sims/study/exact/truth.h"

#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <optional>

#include "kernel/errors.h"
#include "kernel/files.h"
#include "kernel/formats/mesh_io.h"
#include "sims/support/fingerprint.h"

namespace suture::sims {
namespace {

using nlohmann::json;
namespace fs = std::filesystem;

constexpr double kCarryError = 1e-4;  // a step's, of the tolerance: never what limits a reference

/// The text names all that decides what a reference is.
std::string made_from(const Scene& scene, const ExactShape& shape, double time,
                      const TruthOptions& options) {
  std::string text =
      fmt::format("{} {} {} {}\n", options.kind, fingerprint(shape.mesh), time, options.tolerance);
  for (const Phase& phase : scene.phases) {
    text += fmt::format("{} until {}", phase.kind, std::min(phase.until, time));
    for (const auto& [key, value] : phase.parameters)
      text += fmt::format(" {}={}", key, text_of(value));
    text += "\n";
  }
  return text;
}

json to_json(const ExactSurface& e, const std::string& from) {
  json creases = json::array();
  for (const auto& [a, b] : e.creases) creases.push_back({a, b});
  return {{"from", from},
          {"creases", creases},
          {"corners", e.corners},
          {"tolerance", e.tolerance},
          {"mean_error", e.mean_error},
          {"max_error", e.max_error}};
}

ExactSurface from_json(const json& j, Triangles surface) {
  ExactSurface e;
  e.surface = std::move(surface);
  for (const json& pair : j.at("creases")) e.creases.emplace_back(pair.at(0), pair.at(1));
  e.corners = j.at("corners").get<std::vector<std::uint32_t>>();
  e.tolerance = j.at("tolerance");
  e.mean_error = j.at("mean_error");
  e.max_error = j.at("max_error");
  return e;
}

bool in_range(const ExactSurface& e) {
  const std::size_t n = e.surface.positions.size();
  return std::all_of(e.corners.begin(), e.corners.end(), [&](auto v) { return v < n; }) &&
         std::all_of(e.creases.begin(), e.creases.end(),
                     [&](const auto& c) { return c.first < n && c.second < n; });
}

/// The reference that is kept in the folder, if it is whole and made from the same.
std::optional<ExactSurface> kept(const fs::path& mesh, const fs::path& note,
                                 const std::string& from) {
  if (!fs::exists(note) || !fs::exists(mesh)) return {};
  try {
    const json j = json::parse(read_file(note));
    if (j.at("from") != from) return {};
    ExactSurface e = from_json(j, read_triangles(mesh));
    if (in_range(e)) return e;
  } catch (const json::exception&) {  // damaged: it is made again
  } catch (const InvalidInput&) {
  }
  return {};
}

/// Everything is back where it was if no vertex of the coarse mesh has moved by more than a
/// hundredth of the tolerance. Then the exact surface is the start shape, which costs no flow.
bool all_is_back(const ExactShape& shape, const Carry& carry, double tolerance) {
  return std::all_of(shape.mesh.positions.begin(), shape.mesh.positions.end(),
                     [&](const Point& p) { return (carry(p) - p).norm() <= 0.01 * tolerance; });
}

}  // namespace

Truth truth_at(const Scene& scene, double time, const TruthOptions& options) {
  const ExactShape shape = exact_shape(scene, {.polyhedron = options.kind == "polyhedron"});
  const std::string from = made_from(scene, shape, time, options);
  const fs::path mesh = options.folder / (fingerprint(from) + ".ply"),
                 note = options.folder / (fingerprint(from) + ".json");
  Truth truth;
  truth.volume = shape.volume;
  if (!options.folder.empty())
    if (auto e = kept(mesh, note, from)) {
      truth.exact = std::move(*e);
      return truth;
    }
  Carry carry = exact_carry(scene, time, kCarryError * options.tolerance);
  if (all_is_back(shape, carry, options.tolerance)) carry = [](const Point& p) { return p; };
  truth.exact = exact_flow(shape, carry, {.tolerance = options.tolerance});
  if (options.folder.empty()) return truth;
  std::error_code error;
  fs::create_directories(options.folder, error);
  write_triangles(mesh, truth.exact.surface);
  write_file(note, to_json(truth.exact, from).dump() + "\n");
  return truth;
}

}  // namespace suture::sims
