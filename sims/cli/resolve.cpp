// suture resolve: one remodel of the union of static meshes.
#include <fmt/format.h>

#include <algorithm>

#include <nlohmann/json.hpp>

#include "kernel/audit.h"
#include "kernel/errors.h"
#include "kernel/files.h"
#include "kernel/formats/mesh_io.h"
#include "kernel/measure/body_loss.h"
#include "kernel/measure/measures.h"
#include "sims/cli/choices.h"
#include "sims/cli/commands.h"
#include "sims/cli/inputs.h"
#include "sims/output/colours.h"
#include "sims/output/render.h"
#include "sims/output/report_json.h"
#include "sims/tracking/vertex_values.h"
#include "surgery/model/option_table.h"
#include "surgery/tracker.h"

namespace suture::sims {
namespace {

namespace fs = std::filesystem;

struct Settings {
  Inputs inputs;
  fs::path out, report, picture;
  double cells = 0;
  double may_lose = 0.1;  ///< part of a body's volume
  TrackerOptions tracker;
};

double checked_cell_size(const Settings& s, const CLI::App& command, const Triangles& surface) {
  if (command.count("--cell") != 0) return s.tracker.cell_size;
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
  if (!(s.may_lose >= 0 && s.may_lose <= 1))
    throw InvalidInput(
        fmt::format("--may-lose is {}; give a part of a body's volume, 0 to 1", s.may_lose));
  require_writable_mesh(s.out);
  if (!s.report.empty()) require_folder_of(s.report);
  if (!s.picture.empty()) require_writable_picture(s.picture);
  check_paths(s);
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

/// The words for one body's loss, with where it is.
std::string words(const BodyLoss& loss) {
  return fmt::format("{} {} (volume {:.4g}, at {:.4g} {:.4g} {:.4g}) {} {:.3g} % of its volume",
                     loss.volume < 0 ? "cavity" : "body", loss.component + 1, std::abs(loss.volume),
                     loss.centre[0], loss.centre[1], loss.centre[2],
                     loss.volume < 0 ? "is filled by" : "loses", 100 * loss.part);
}

/// The bodies that lost a hundredth or more: less is what rounding off at seams takes, and the
/// error of the measure.
std::vector<BodyLoss> notable_losses(const Triangles& before, const Triangles& after) {
  std::vector<BodyLoss> losses = body_losses(before, after);
  std::erase_if(losses, [](const BodyLoss& loss) { return loss.part < 0.01; });
  return losses;
}

/// \throw InvalidInput where a body has lost more than it may
void check_losses(const std::vector<BodyLoss>& losses, const Settings& s) {
  std::size_t more = 0;
  const BodyLoss* worst = nullptr;
  for (const BodyLoss& loss : losses) {
    if (loss.part <= s.may_lose) continue;
    ++more;
    if (!worst || loss.part > worst->part) worst = &loss;
  }
  if (!worst) return;
  throw InvalidInput(fmt::format(
      "with cells of {:.4g}, {}{}; nothing was written. What is thinner than a cell goes: give "
      "smaller cells, --events merge, or allow it by --may-lose {:.2g}",
      s.tracker.cell_size, words(*worst),
      more > 1 ? fmt::format(", and {} more lose more than {:.3g} %", more - 1, 100 * s.may_lose)
               : "",
      std::min(1.0, std::ceil(100 * worst->part) / 100)));
}

nlohmann::json json_of(const std::vector<BodyLoss>& losses) {
  nlohmann::json all = nlohmann::json::array();
  for (const BodyLoss& loss : losses)
    all.push_back({{"body", loss.component + 1},
                   {"volume", loss.volume},
                   {"part_lost", loss.part},
                   {"centre", {loss.centre[0], loss.centre[1], loss.centre[2]}}});
  return all;
}

/// The end of the one-line result: the bodies that lost most.
std::string told(std::vector<BodyLoss> losses) {
  constexpr std::size_t kTold = 3;
  std::stable_sort(losses.begin(), losses.end(),
                   [](const BodyLoss& a, const BodyLoss& b) { return a.part > b.part; });
  std::string text;
  for (std::size_t i = 0; i < std::min(kTold, losses.size()); ++i) text += "; " + words(losses[i]);
  if (losses.size() > kTold) text += fmt::format("; {} more lose some", losses.size() - kTold);
  return text;
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
  Tracker tracker(input, s.tracker);
  const SurgeryReport report = remodel(tracker, s);
  const Triangles& surface = tracker.surface();
  if (surface.triangles.empty())
    throw InvalidInput(
        "nothing is left of the input at this cell size: every part is thinner than "
        "a cell; give a smaller cell, or --events merge");
  const std::vector<BodyLoss> losses = report.outcome == Outcome::committed
                                           ? notable_losses(input, surface)
                                           : std::vector<BodyLoss>{};
  check_losses(losses, s);
  write_triangles(s.out, surface);  // first: if it fails, nothing else is left behind
  if (!s.picture.empty()) render_png(surface, patches(surface, report), {}, s.picture);
  if (!s.report.empty()) {
    nlohmann::json json = to_json(report);
    json["inputs"] = s.inputs.files;
    json["options"] = to_json(s.tracker);
    json["before"] = measured(input);
    json["after"] = measured(surface);
    json["losses"] = json_of(losses);
    write_file(s.report, json.dump(1) + "\n");
  }
  fmt::print(
      "{}: {} triangles, {} components before; {} triangles, {} components after; {} cells "
      "re-sampled{}\n",
      s.out.string(), input.triangles.size(), components(input).count, surface.triangles.size(),
      components(surface).count, report.marked.total(), told(losses));
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
  add_option_flags(*size, tracker_options(), s->tracker, {{"--cell", "cell_size"}});
  size->add_option("--cells", s->cells, "Cells along the longest axis of the common bounding box")
      ->type_name("N");
  add_option_flags(*command, tracker_options(), s->tracker,
                   {{"--events", "events"},
                    {"--collapse", "collapse"},
                    {"--placement", "placement"},
                    {"--cell-test", "cell_test"},
                    {"--arithmetic", "arithmetic"},
                    {"--jitter", "jitter"},
                    {"--restarts", "most_restarts"},
                    {"--depth", "depth"},
                    {"--origin", "origin"}});
  command->add_flag("--repair", s->inputs.mend, "Mend what has one right answer, and say what");
  command
      ->add_option("--may-lose", s->may_lose,
                   "Part of its volume that any body may lose, or of a cavity that may be filled")
      ->type_name("PART")
      ->capture_default_str();
  command->add_option("--report", s->report, "Write the report as JSON")->type_name("R.json");
  command->add_option("--picture", s->picture, "Draw the result; what is new is in colour")
      ->type_name("P.png");
  command->callback([s, command, &exit] {
    resolve(*s, *command);
    exit = kDone;
  });
}

}  // namespace suture::sims
