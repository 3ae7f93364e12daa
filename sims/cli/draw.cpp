// suture draw: meshes side by side in one picture, drawn alike.
#include <fmt/format.h>

#include <algorithm>

#include "kernel/errors.h"
#include "kernel/formats/mesh_io.h"
#include "sims/cli/commands.h"
#include "sims/cli/inputs.h"
#include "sims/output/render.h"
#include "sims/scene/scene.h"

namespace suture::sims {
namespace {

struct Settings {
  std::vector<std::string> files, labels;
  std::filesystem::path out, scene;
  PictureOptions picture;
  std::vector<double> direction, up, cut_point, cut_normal, low, high;
  int columns = 0;
};

Point point_of(const std::vector<double>& xyz, const char* flag) {
  const Point p(xyz[0], xyz[1], xyz[2]);
  if (!p.allFinite()) throw InvalidInput(std::string(flag) + ": give three finite numbers");
  return p;
}

/// The scene's picture, and over it what flags were given.
PictureOptions picture_of(const Settings& s, const CLI::App& command) {
  PictureOptions p = s.scene.empty() ? s.picture : read_picture_options(s.scene);
  if (command.count("--width") != 0) p.width = s.picture.width;
  if (command.count("--height") != 0) p.height = s.picture.height;
  if (command.count("--zoom") != 0) p.zoom = s.picture.zoom;
  if (command.count("--edges") != 0) p.edges = s.picture.edges;
  if (command.count("--feature-angle") != 0) p.feature_angle = s.picture.feature_angle;
  if (!s.direction.empty()) p.direction = point_of(s.direction, "--direction");
  if (!s.up.empty()) p.up = point_of(s.up, "--up");
  if (!s.low.empty()) p.fit = Box{point_of(s.low, "--low"), point_of(s.high, "--high")};
  if (!(p.zoom > 0) || !(p.feature_angle >= 0 && p.feature_angle <= 180))  // CLI11 lets NaN pass
    throw InvalidInput("--zoom is above 0, and --feature-angle from 0 to 180 degrees");
  if (!s.low.empty() && !((p.fit->high - p.fit->low).minCoeff() > 0))
    throw InvalidInput("--low and --high: each number of the second must be above the first's");
  if (s.cut_point.empty()) return p;
  p.cut = CutPlane{point_of(s.cut_point, "--cut-point"), point_of(s.cut_normal, "--cut-normal")};
  if (!(p.cut->normal.norm() > 0)) throw InvalidInput("--cut-normal has no direction");
  return p;
}

void draw(const Settings& s, const CLI::App& command) {
  require_writable_picture(s.out);
  if (!s.labels.empty() && s.labels.size() != s.files.size())
    throw InvalidInput(fmt::format("{} labels for {} meshes; give one for each, or none",
                                   s.labels.size(), s.files.size()));
  PictureOptions picture = picture_of(s, command);
  std::vector<Triangles> surfaces;
  std::vector<Point> all;
  for (const std::string& file : s.files) {
    surfaces.push_back(read_triangles(file));
    const Box box = bounding_box(surfaces.back().positions);
    all.insert(all.end(), {box.low, box.high});
  }
  if (!picture.fit) picture.fit = bounding_box(all);
  std::vector<Panel> panels;
  for (std::size_t i = 0; i < surfaces.size(); ++i)
    panels.push_back({&surfaces[i], {}, s.labels.empty() ? "" : s.labels[i]});
  const int all_in_a_row = static_cast<int>(panels.size());
  const int columns = s.columns > 0 ? std::min(s.columns, all_in_a_row) : all_in_a_row;
  render_panels(panels, {columns}, picture, s.out);
}

/// Three numbers X Y Z, or X,Y,Z.
CLI::Option* add_point(CLI::App& command, const std::string& flag, std::vector<double>& to,
                       const std::string& help) {
  return command.add_option(flag, to, help)->expected(3)->delimiter(',')->type_name("X");
}

}  // namespace

void add_draw(CLI::App& app, int& exit) {
  auto s = std::make_shared<Settings>();
  CLI::App* command = app.add_subcommand("draw", "Draw meshes side by side, all alike");
  command->add_option("meshes", s->files, "Meshes: OBJ, OFF, PLY or STL")
      ->required()
      ->type_name("MESH");
  command->add_option("-o,--output", s->out, "Picture to write")->required()->type_name("PNG");
  command
      ->add_option("--scene", s->scene, "Scene whose [pictures] table is taken; flags go over it")
      ->type_name("SCENE.toml");
  command->add_option("--label", s->labels, "Over each mesh, in their order: repeat the flag")
      ->allow_extra_args(false);
  command->add_option("--columns", s->columns, "Meshes in a row; default: all")
      ->check(CLI::Range(1, 100));
  command->add_option("--width", s->picture.width, "Pixels of one mesh's panel");
  command->add_option("--height", s->picture.height, "Pixels of one mesh's panel");
  command->add_option("--zoom", s->picture.zoom, "Above 1: closer")->check(CLI::PositiveNumber);
  command->add_option("--feature-angle", s->picture.feature_angle, "Sharper edges are drawn sharp");
  command->add_flag("--edges", s->picture.edges, "Draw triangle edges");
  add_point(*command, "--direction", s->direction, "The way the camera looks");
  add_point(*command, "--up", s->up, "What is up in the picture");
  CLI::Option* low = add_point(*command, "--low", s->low, "Corner of the box that is shown");
  CLI::Option* high = add_point(*command, "--high", s->high, "The corner across");
  CLI::Option* at =
      add_point(*command, "--cut-point", s->cut_point, "A point of a plane that cuts");
  CLI::Option* normal = add_point(*command, "--cut-normal", s->cut_normal,
                                  "Where it points to is cut away, and the inside shown");
  low->needs(high);
  high->needs(low);
  at->needs(normal);
  normal->needs(at);
  command->callback([s, command, &exit] {
    draw(*s, *command);
    exit = kDone;
  });
}

}  // namespace suture::sims
