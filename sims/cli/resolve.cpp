// suture resolve: one remodel of the union of static meshes.
#include <fmt/format.h>

#include <algorithm>

#include <nlohmann/json.hpp>

#include "kernel/audit.h"
#include "kernel/errors.h"
#include "kernel/files.h"
#include "kernel/formats/mesh_io.h"
#include "kernel/measure/measures.h"
#include "sims/cli/choices.h"
#include "sims/cli/commands.h"
#include "sims/cli/inputs.h"
#include "sims/output/colours.h"
#include "sims/output/render.h"
#include "sims/output/report_json.h"
#include "sims/scene/option_names.h"
#include "sims/tracking/vertex_values.h"
#include "surgery/tracker.h"

namespace suture::sims {
namespace {

namespace fs = std::filesystem;

struct Settings {
  Inputs inputs;
  fs::path out, report, picture;
  double cell_size = 0, cells = 0;
  std::vector<double> origin;
  TrackerOptions tracker;
};

double checked_cell_size(const Settings& s, const CLI::App& command, const Triangles& surface) {
  if (command.count("--cell") != 0) {
    if (!std::isfinite(s.cell_size) || !(s.cell_size > 0))
      throw InvalidInput(fmt::format(
          "--cell is {}; give the edge of a cell, a finite length above zero", s.cell_size));
    return s.cell_size;
  }
  if (!(s.cells >= 1) || !(s.cells <= kMaxPlanes) || s.cells != std::floor(s.cells))
    throw InvalidInput(
        fmt::format("--cells is {}; give a whole number from 1 to {}: the cells "
                    "along the longest axis of the bounding box",
                    s.cells, kMaxPlanes));
  const Box box = bounding_box(surface.positions);
  const double size = (box.high - box.low).maxCoeff() / s.cells;
  if (!std::isfinite(size) || !(size > 0))
    throw InvalidInput(
        "the bounding box of the input has no finite size above zero; --cells has "
        "no meaning for it");
  return size;
}

/// The mesh may take an input's place; nothing else may take another file's.
void check_paths(const Settings& s) {
  const auto apart = [](const fs::path& a, const std::string& option, const fs::path& b,
                        const std::string& other) {
    if (!a.empty() && !b.empty() && same_file(a, b))
      throw InvalidInput(fmt::format("{} is {}, which is also {}; give it a name of its own",
                                     option, a.string(), other));
  };
  apart(s.report, "--report", s.out, "the mesh to write");
  apart(s.picture, "--picture", s.out, "the mesh to write");
  apart(s.picture, "--picture", s.report, "the report");
  for (const std::string& input : s.inputs.files) {
    apart(s.report, "--report", input, "an input");
    apart(s.picture, "--picture", input, "an input");
  }
}

void check_options(const Settings& s) {
  require_writable_mesh(s.out);
  if (!s.report.empty()) require_folder_of(s.report);
  if (!s.picture.empty()) require_writable_picture(s.picture);
  check_paths(s);
  if (s.tracker.depth < 0)
    throw InvalidInput(fmt::format("--depth is {}; give 0 or more whole cells", s.tracker.depth));
}

/// The remodel itself; whatever goes wrong inside leaves the input beside the output.
SurgeryReport remodel(Tracker& tracker, const Settings& s) {
  const Triangles before = tracker.surface();
  const auto refuse = [&](const std::string& why) {
    const fs::path mesh = reproducer_beside(s.out);
    write_triangles(mesh, before);
    throw InternalFailure("resolve",
                          why + "; nothing was written but the input, saved as " + mesh.string());
  };
  SurgeryReport report;
  try {
    report = tracker.remodel();
  } catch (const InvalidInput&) {
    throw;
  } catch (const std::bad_alloc&) {
    throw InvalidInput("there is not enough memory for this many cells; give a larger cell");
  } catch (const std::exception& error) {
    refuse(error.what());
  }
  if (report.outcome == Outcome::refused) refuse(report.failure);
  const Audit result = audit(tracker.surface());
  if (!tracker.surface().triangles.empty() && !result.closed_manifold()) refuse(result.first);
  return report;
}

TriangleColours patches(const Triangles& surface, const SurgeryReport& report) {
  if (report.outcome != Outcome::committed) return {};
  std::vector<double> fresh(surface.positions.size(), 1.0);
  for (const std::uint32_t v : report.vertex_map)
    if (v != kNone) fresh[v] = 0;
  return patch_colours(surface, fresh);
}

void resolve(Settings s, const CLI::App& command) {
  check_options(s);
  const Triangles input = read_union(s.inputs);
  s.tracker.cell_size = checked_cell_size(s, command, input);
  if (!s.origin.empty()) s.tracker.origin = Point(s.origin[0], s.origin[1], s.origin[2]);
  if (!s.tracker.origin.allFinite()) throw InvalidInput("--origin must be three finite numbers");
  Tracker tracker(input, s.tracker);
  const SurgeryReport report = remodel(tracker, s);
  const Triangles& surface = tracker.surface();
  if (surface.triangles.empty())
    throw InvalidInput(
        "nothing is left of the input at this cell size: every part is thinner than "
        "a cell; give a smaller cell, or --events merge");
  write_triangles(s.out, surface);  // first: if it fails, nothing else is left behind
  if (!s.picture.empty()) render_png(surface, patches(surface, report), {}, s.picture);
  if (!s.report.empty()) {
    nlohmann::json json = to_json(report);
    json["inputs"] = s.inputs.files;
    json["options"] = to_json(s.tracker);
    json["before"] = measured(input);
    json["after"] = measured(surface);
    write_file(s.report, json.dump(1) + "\n");
  }
  fmt::print(
      "{}: {} triangles, {} components before; {} triangles, {} components after; {} cells "
      "re-sampled\n",
      s.out.string(), input.triangles.size(), components(input).count, surface.triangles.size(),
      components(surface).count, report.marked.total());
}

}  // namespace

void add_resolve(CLI::App& app, int& exit) {
  auto s = std::make_shared<Settings>();
  CLI::App* command = app.add_subcommand(
      "resolve", "Turn overlapping or tangled closed meshes into one closed surface");
  command->add_option("inputs", s->inputs.files, "Meshes: OBJ, OFF, PLY or STL")
      ->required()
      ->type_name("IN");
  command->add_option("-o,--output", s->out, "Mesh to write, its format by the extension")
      ->required()
      ->type_name("OUT");
  auto* size = command->add_option_group("size of a cell")->require_option(1);
  size->add_option("--cell", s->cell_size, "Edge of a topology cell")->type_name("H");
  size->add_option("--cells", s->cells, "Cells along the longest axis of the common bounding box")
      ->type_name("N");
  add_choice(*command, "--events", s->tracker.events, kEventsNames,
             "What may happen: merge, split, both (the default) or none");
  add_choice(*command, "--collapse", s->tracker.collapse, kCollapseNames,
             "Vertices on the region's boundary: straighten (the default), keep or paper");
  add_choice(*command, "--placement", s->tracker.placement, kPlacementNames,
             "New vertices: crossing (the default) or distance_field");
  add_choice(*command, "--cell-test", s->tracker.cell_test, kCellTestNames,
             "Cells to re-sample: deep (the default) or plain");
  add_choice(*command, "--arithmetic", s->tracker.arithmetic, kArithmeticNames,
             "Signs: filtered (exact, the default), rational (exact, slow) or rounded (may fail)");
  command
      ->add_option("--jitter", s->tracker.jitter,
                   "With --arithmetic rounded: move vertices by up to this part of a cell")
      ->type_name("X");
  command
      ->add_option("--restarts", s->tracker.most_restarts,
                   "With --collapse paper: gridlocks after which the surgery is refused")
      ->type_name("N");
  command->add_option("--depth", s->tracker.depth, "Cells between a deep cell and the isosurface")
      ->type_name("N");
  command->add_option("--origin", s->origin, "A node of the lattice: X Y Z")
      ->expected(3)
      ->type_name("X");
  command->add_flag("--repair", s->inputs.mend, "Mend what has one right answer, and say what");
  command->add_option("--report", s->report, "Write the report as JSON")->type_name("R.json");
  command->add_option("--picture", s->picture, "Draw the result; what is new is in colour")
      ->type_name("P.png");
  command->callback([s, command, &exit] {
    resolve(*s, *command);
    exit = kDone;
  });
}

}  // namespace suture::sims
