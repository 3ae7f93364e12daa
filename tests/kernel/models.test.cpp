// The classic meshes are what data/models.toml says of them, as far as they are at hand.
#include "tests/models.h"

#include <toml++/toml.h>
#include <catch2/catch.hpp>
#include <fstream>
#include <iostream>
#include <sstream>

#include "kernel/audit.h"
#include "kernel/errors.h"
#include "kernel/measure/measures.h"
#include "kernel/repair/orientation.h"
#include "tests/paths.h"

using namespace suture;

namespace {

// "closed manifold", with its components that are inside-out; or all that keeps it from being one.
std::string condition(const Triangles& surface) {
  const Audit a = audit(surface);
  std::ostringstream out;
  if (a.closed_manifold()) {
    out << "closed manifold";
    if (const auto wrong = inside_out_components(surface).size(); wrong > 0)
      out << ", " << wrong << " of " << components(surface).count << " components inside-out";
  } else {
    const char* separator = "";
    const auto say = [&](std::size_t count, const char* what) {
      if (count > 0) out << separator << what << ": " << count;
      if (count > 0) separator = ", ";
    };
    say(a.border_edges, "open, border edges");
    say(a.non_manifold_edges, "non-manifold edges");
    say(a.misoriented_edges, "misoriented edges");
    say(a.non_manifold_vertices, "non-manifold vertices");
    say(a.degenerate_triangles, "degenerate triangles");
    say(a.duplicate_triangles, "duplicate triangles");
  }
  if (a.isolated_vertices > 0) out << ", isolated vertices: " << a.isolated_vertices;
  return out.str();
}

struct Facts {
  std::size_t triangles = 0;
  std::string condition;
};

Facts facts(const std::filesystem::path& path) {
  try {
    const Triangles surface = read_triangles(path);
    return {surface.triangles.size(), condition(surface)};
  } catch (const InvalidInput&) {
    return {0, "cannot be read"};
  }
}

}  // namespace

TEST_CASE("every classic mesh at hand is what models.toml says of it", "[slow]") {
  const toml::table list = toml::parse_file(source_dir() + "/data/models.toml");
  const toml::array& models = *list["model"].as_array();
  CHECK(models.size() >= 140);
  std::size_t seen = 0;
  for (const toml::node& node : models) {
    const toml::table& model = *node.as_table();
    const auto file = model["file"].value<std::string>().value();
    const auto path = classic_path(file);
    if (!path) continue;
    INFO(file);
    const Facts found = facts(*path);
    CHECK(found.triangles == model["triangles"].value<std::size_t>().value());
    CHECK(found.condition == model["condition"].value<std::string>().value());
    ++seen;
  }
  if (seen == 0) WARN("no classic mesh is at hand (data/fetch_models brings them): none checked");
}

TEST_CASE("describe the meshes of $DESCRIBE for data/list_models", "[.describe]") {
  const char* const folder = std::getenv("DESCRIBE");
  REQUIRE(folder != nullptr);
  for (const auto& entry : std::filesystem::directory_iterator(folder)) {
    if (!has_mesh_extension(entry.path())) continue;
    const Facts found = facts(entry.path());
    std::cout << "FACTS\t" << entry.path().filename().string() << '\t' << found.triangles << '\t'
              << found.condition << '\n';
  }
}
