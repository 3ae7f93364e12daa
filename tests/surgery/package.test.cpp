// Every mesh of Debian's libcgal-demo, through whole remodels or to a refusal.
#include <algorithm>
#include <catch2/catch.hpp>
#include <fstream>
#include <iostream>

#include "kernel/errors.h"
#include "kernel/repair/repair.h"
#include "tests/models.h"
#include "tests/paths.h"
#include "tests/skip.h"
#include "tests/surgery/support.h"

using namespace suture;
using namespace suture::surgery;

namespace {

struct Listed {
  std::string file, condition;
};

/// The meshes of data/models.toml that come from the package.
std::vector<Listed> listed() {
  std::vector<Listed> all;
  Listed model;
  bool ours = false;
  auto value = [](const std::string& line) {
    return line.substr(line.find('"') + 1, line.rfind('"') - line.find('"') - 1);
  };
  std::ifstream list(source_dir() + "/data/models.toml");
  for (std::string line; std::getline(list, line);) {
    if (line.starts_with("file = ")) model.file = value(line);
    if (line.starts_with("package = ")) ours = value(line) == "libcgal-demo";
    if (!line.starts_with("condition = ")) continue;
    model.condition = value(line);
    if (ours) all.push_back(model);
    ours = false;
  }
  return all;
}

constexpr auto kMissing =
    "the meshes of libcgal-demo are not at hand; data/fetch_models brings them";

std::vector<Listed> at_hand(const std::vector<Listed>& all) {
  std::vector<Listed> here;
  for (const Listed& model : all)
    if (classic_path(model.file)) here.push_back(model);
  return here;
}

bool is_closed(const Listed& model) { return model.condition.starts_with("closed manifold"); }

Triangles resolved(const Triangles& surface, double cell, const std::string& what) {
  Tracker tracker(surface, {.cell_size = cell});
  const SurgeryReport report = tracker.remodel();
  const Audit result = audit(tracker.surface());
  CAPTURE(what, report.failure, result.first);
  CHECK(report.outcome != Outcome::refused);
  CHECK(result.closed_manifold());
  return tracker.surface();
}

void resolve_all(int cells) {
  const std::vector<Listed> all = listed();
  REQUIRE(std::count_if(all.begin(), all.end(), is_closed) >= 82);
  const std::vector<Listed> here = at_hand(all);
  if (here.empty()) SUTURE_SKIP(kMissing);
  std::size_t closed = 0;
  for (const Listed& model : here) {
    Triangles mesh;
    try {
      mesh = read_triangles(*classic_path(model.file));
      require_closed_manifold(mesh, model.file);
    } catch (const InvalidInput&) {
      continue;  // their own test follows
    }
    ++closed;
    repair(mesh);  // some are inside-out
    const Box box = bounding_box(mesh.positions);
    const double cell = (box.high - box.low).maxCoeff() / cells;
    const Triangles alone = resolved(mesh, cell, model.file);
    CAPTURE(model.file, cells);
    CHECK(resolved(together(mesh, mesh), cell, model.file + " twice") == alone);
    resolved(together(mesh, translated(mesh, 0.1 * (box.high - box.low))), cell,
             model.file + " shifted");
    if (!alone.triangles.empty()) CHECK(resolved(alone, cell, model.file + " again") == alone);
  }
  CHECK(closed >= 82);
}

}  // namespace

TEST_CASE("every closed mesh of the package is resolved at 20 cells", "[slow]") { resolve_all(20); }
TEST_CASE("every closed mesh of the package is resolved at 64 cells", "[slow]") { resolve_all(64); }
TEST_CASE("every closed mesh of the package is resolved at 150 cells", "[slow]") {
  resolve_all(150);
}

TEST_CASE("every broken mesh of the package is refused with its reason") {
  const std::vector<Listed> all = listed();
  REQUIRE_FALSE(std::all_of(all.begin(), all.end(), is_closed));
  std::size_t refused = 0;
  const std::vector<Listed> here = at_hand(all);
  if (here.empty()) SUTURE_SKIP(kMissing);
  for (const Listed& model : here) {
    if (is_closed(model)) continue;
    CAPTURE(model.file, model.condition);
    try {
      const Triangles mesh = read_triangles(*classic_path(model.file));
      CHECK_THROWS_AS(require_usable(mesh, model.file), InvalidInput);
    } catch (const InvalidInput& refusal) {
      CHECK(std::string(refusal.what()).size() > 20);
    }
    ++refused;
  }
  CHECK(refused > 0);
}
