// suture run: a scene from start to end.
#include "sims/driver/run.h"

#include <fmt/format.h>

#include "sims/cli/changes.h"
#include "sims/cli/commands.h"
#include "sims/cli/progress_bar.h"

namespace suture::sims {
namespace {

struct Settings {
  std::filesystem::path scene, folder;
  ChangeOptions change;
};

int run_scene(const Settings& s) {
  Scene scene = read_scene(s.scene, read_changes(s.change));
  for (const std::string& note : scene.notes) fmt::print(stderr, "{}\n", note);
  RunSummary r;
  {
    ProgressBar bar;
    r = run(scene, s.folder, &bar);
  }
  fmt::print(
      "{}: {} steps, {} remodels of which {} changed the surface; {} merged, {} split off; "
      "{} meshes, {} pictures and report.json in {}\n",
      scene.title, r.steps, r.remodels, r.committed, r.merges, r.splits, r.meshes, r.pictures,
      s.folder.string());
  if (r.vanished != 0)
    fmt::print(stderr,
               "{} bodies vanished, being thinner than a cell: \"vanished\" of \"remodels\" in "
               "report.json says when and where; smaller cells or events = \"merge\" keep them\n",
               r.vanished);
  if (r.refused != 0)
    fmt::print(stderr, "{} surgeries were refused, the first because: {}; reproducer: {}\n",
               r.refused, r.failure, r.reproducer);
  if (r.unconverged != 0)
    fmt::print(stderr,
               "{} linear solves of the fluid did not converge, and their last iterates were used: "
               "see \"unconverged\" in report.json; give the fluid a larger most_iterations or "
               "shorter steps (cfl)\n",
               r.unconverged);
  if (!r.audit.closed_manifold())
    fmt::print(stderr, "the last surface is not a closed manifold: {}\n", r.audit.first);
  return r.refused == 0 && r.audit.closed_manifold() ? kDone : kFailure;
}

}  // namespace

void add_run(CLI::App& app, int& exit) {
  auto s = std::make_shared<Settings>();
  CLI::App* command = app.add_subcommand("run", "Run a scene");
  command->add_option("scene", s->scene, "Scene file")->required()->type_name("SCENE.toml");
  command->add_option("-o,--output", s->folder, "Folder for meshes, pictures and report.json")
      ->required()
      ->type_name("DIR");
  add_change_options(*command, s->change);
  command->callback([s, &exit] { exit = run_scene(*s); });
}

}  // namespace suture::sims
