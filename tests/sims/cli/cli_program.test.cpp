#include "tests/sims/cli/program.h"

#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>

#include "kernel/audit.h"
#include "kernel/files.h"
#include "kernel/formats/mesh_io.h"
#include "kernel/measure/measures.h"
#include "kernel/shapes/shapes.h"
#include "kernel/shapes/transform.h"
#include "sims/output/report_json.h"
#include "tests/sims/balls.h"

using namespace suture;
using namespace suture::sims;
using Catch::Matchers::Contains;
using nlohmann::json;

namespace {

/// Two overlapping balls in two files.
void write_balls(const Folder& folder) {
  const Triangles ball = subdivided_ball(3, 1);
  write_triangles(folder / "a.ply", ball);
  write_triangles(folder / "b.ply", translated(ball, Point(1.1, 0.07, 0.03)));
}

Triangles open_ball() {
  Triangles ball = subdivided_ball(2, 1);
  ball.triangles.pop_back();
  return ball;
}

}  // namespace

TEST_CASE("the program says its version and its help, and wants a subcommand") {
  CHECK(suture_program("--version").text == "suture 0.1.0\n");
  CHECK(suture_program("--version").exit == 0);
  const Said help = suture_program("--help");
  CHECK(help.exit == 0);
  CHECK_THAT(help.text, Contains("resolve") && Contains("check") && Contains("make") &&
                            Contains("run") && Contains("Exit codes"));
  CHECK(suture_program("").exit == 2);
  CHECK(suture_program("dissolve").exit == 2);
  CHECK(suture_program("resolve --help").exit == 0);
  CHECK_THAT(suture_program("make --help").text, Contains("dumbbell"));
}

TEST_CASE("resolve makes one closed surface of two overlapping balls") {
  const Folder folder;
  write_balls(folder);
  const Said said = suture_program("resolve " + folder.name("a.ply") + " " + folder.name("b.ply") +
                                   " -o " + folder.name("out.obj") + " --cells 24 --report " +
                                   folder.name("r.json") + " --picture " + folder.name("p.png"));
  INFO(said.text);
  REQUIRE(said.exit == 0);
  const Triangles out = read_triangles(folder / "out.obj");
  CHECK(audit(out).closed_manifold());
  CHECK(components(out).count == 1);
  CHECK(euler_characteristic(out) == 2);
  const json report = json::parse(contents(folder / "r.json"));
  CHECK(report["outcome"] == "committed");
  CHECK(report["components_after"] == 1);
  CHECK(report["coincident_triangles"] == 0);
  CHECK(report["before"]["components"] == 2);
  CHECK(report["options"]["cell_size"].get<double>() == Approx(3.1 / 24));
  CHECK(contents(folder / "p.png").substr(1, 3) == "PNG");
  CHECK(folder.files() == 5);
}

TEST_CASE("resolve refuses to lose a thin body unless told that it may, and then says so") {
  const Folder folder;
  const Triangles plate =
      translated(box({.size = {1, 1, 0.02}, .edge_length = 0.1}), {3, 0, 0.057});
  write_triangles(folder / "in.ply", merged(std::vector<Triangles>{subdivided_ball(3, 1), plate}));
  const std::string start =
      "resolve " + folder.name("in.ply") + " --cells 40 -o " + folder.name("out.ply");
  const Said refused = suture_program(start);
  INFO(refused.text);
  CHECK(refused.exit == 2);
  CHECK_THAT(refused.text, Contains("body 2") && Contains("--may-lose 1") &&
                               Contains("--events merge") && Contains("smaller cells"));
  CHECK(folder.files() == 1);
  const Said told = suture_program(start + " --may-lose 1 --report " + folder.name("r.json"));
  INFO(told.text);
  CHECK(told.exit == 0);
  CHECK_THAT(told.text, Contains("body 2") && Contains("loses") && Contains("% of its volume"));
  CHECK_THAT(suture::read_file(folder / "r.json"), Contains("\"part_lost\""));
  const Said merged_only = suture_program(start + " --events merge");
  INFO(merged_only.text);
  CHECK(merged_only.exit == 0);
  CHECK_THAT(merged_only.text, !Contains("loses"));
  CHECK(suture_program(start + " --may-lose 1.5").exit == 2);
}

TEST_CASE("resolve takes every one of its options") {
  const Folder folder;
  write_balls(folder);
  const Said said = suture_program(
      "resolve " + folder.name("a.ply") + " -o " + folder.name("out.off") +
      " --cell 0.2 --events none --collapse keep --depth 2 --arithmetic rational --placement "
      "crossing --cell-test plain --origin 0.1 0.2 -0.3 --repair");
  INFO(said.text);
  REQUIRE(said.exit == 0);
  CHECK(read_triangles(folder / "out.off").triangles.size() ==
        read_triangles(folder / "a.ply").triangles.size());
}

TEST_CASE("resolve refuses bad cells and bad options with exit code 2 and writes nothing") {
  const Folder folder;
  write_balls(folder);
  const std::string start =
      "resolve " + folder.name("a.ply") + " -o " + folder.name("out.ply") + " ";
  for (const char* bad : {"",
                          "--cell 0",
                          "--cell -1",
                          "--cell nan",
                          "--cell inf",
                          "--cell 1e-9",
                          "--cell 1e-300",
                          "--cell x",
                          "--cells 0",
                          "--cells -3",
                          "--cells 2.5",
                          "--cells 1e9",
                          "--cells nan",
                          "--cell 0.1 --cells 10",
                          "--cell 0.1 --events maybe",
                          "--cell 0.1 --events 1",
                          "--cell 0.1 --picture picture.jpg",
                          "--cell 0.1 --collapse all",
                          "--cell 0.1 --arithmetic float",
                          "--cell 0.1 --depth -1",
                          "--cell 0.1 --depth 1.5",
                          "--cell 0.1 --origin 1 2",
                          "--cell 0.1 --origin 1 2 nan",
                          "--cell 0.1 --unknown",
                          "--cell 0.1 --report no/such/folder/r.json"}) {
    const Said said = suture_program(start + bad);
    INFO(bad << ": " << said.text);
    CHECK(said.exit == 2);
    CHECK(said.text.size() > 10);
    CHECK(folder.files() == 2);
  }
}

TEST_CASE("resolve refuses files it cannot use with exit code 2 and writes nothing") {
  const Folder folder;
  write_triangles(folder / "open.ply", open_ball());
  Triangles inside_out = subdivided_ball(1, 1);
  for (Triangle& t : inside_out.triangles) std::swap(t[1], t[2]);
  write_triangles(folder / "inside-out.ply", inside_out);
  folder.write("empty.obj", "");
  folder.write("nan.obj", "v 0 0 nan\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
  folder.write("range.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 9\n");
  folder.write("mesh.xyz", "0 0 0\n");
  for (const char* name : {"open.ply", "inside-out.ply", "empty.obj", "nan.obj", "range.obj",
                           "mesh.xyz", "missing.ply"}) {
    const Said said = suture_program("resolve " + folder.name(name) + " -o " +
                                     folder.name("out.ply") + " --cells 10");
    INFO(said.text);
    CHECK(said.exit == 2);
    CHECK_THAT(said.text, Contains(name));
    CHECK(folder.files() == 6);
  }
  const Said mended = suture_program("resolve --repair " + folder.name("inside-out.ply") + " -o " +
                                     folder.name("out.ply") + " --cells 10");
  INFO(mended.text);
  CHECK(mended.exit == 0);
  CHECK(volume(read_triangles(folder / "out.ply")) > 0);
}

TEST_CASE("an output that cannot be written is refused before anything is computed") {
  const Folder folder;
  write_balls(folder);
  for (const std::string& out :
       {folder.name("out.xyz"), folder.name("out"), folder.name("none/out.ply")}) {
    const Said said =
        suture_program("resolve " + folder.name("a.ply") + " -o " + out + " --cells 10");
    INFO(said.text);
    CHECK(said.exit == 2);
    CHECK(folder.files() == 2);
  }
}

TEST_CASE("a choice that is unknown is refused with the names that are known") {
  const Said said = suture_program("resolve a.ply -o b.ply --cells 9 --events foo");
  CHECK(said.exit == 2);
  CHECK_THAT(said.text, Contains("merge, split, both, none") && !Contains("FAILED"));
}

TEST_CASE("resolve refuses to write two files to one place, or a report over an input") {
  const Folder folder;
  write_balls(folder);
  const std::string before = contents(folder / "a.ply");
  std::filesystem::create_symlink("a.ply", folder / "link.png");
  for (const std::string& bad :
       {"--report " + folder.name("a.ply"), "--report " + folder.name("./out.ply"),
        "--picture " + folder.name("link.png"),
        "--picture " + folder.name("x.png") + " --report " + folder.name("x.png")}) {
    const Said said = suture_program("resolve " + folder.name("a.ply") + " -o " +
                                     folder.name("out.ply") + " --cells 10 " + bad);
    INFO(bad << ": " << said.text);
    CHECK(said.exit == 2);
    CHECK_THAT(said.text, Contains("a name of its own"));
    CHECK(folder.files() == 3);
  }
  CHECK(contents(folder / "a.ply") == before);
  const Said over = suture_program("resolve " + folder.name("b.ply") + " -o " +
                                   folder.name("b.ply") + " --cells 10");
  INFO(over.text);
  CHECK(over.exit == 0);
}

TEST_CASE("check counts no pairs where triangles repeat, and stops counting at a million") {
  const Folder folder;
  const Triangles ball = subdivided_ball(2, 1);
  write_triangles(folder / "many.ply", merged(std::vector<Triangles>(80, ball)));
  CHECK_THAT(suture_program("check " + folder.name("many.ply")).text,
             Contains("more than 1000000"));
  const json many = json::parse(suture_program("check --json " + folder.name("many.ply")).text);
  CHECK(many[0]["measures"]["self_intersecting_pairs"] == 1000000);
  CHECK(many[0]["measures"]["self_intersecting_pairs_capped"] == true);
  Triangles twice = ball;
  twice.triangles.push_back(twice.triangles.front());
  write_triangles(folder / "twice.ply", twice);
  CHECK_THAT(suture_program("check " + folder.name("twice.ply")).text,
             Contains("not counted: duplicate triangles"));
}

TEST_CASE("standard output that cannot be written gives exit code 2") {
  const Folder folder;
  write_balls(folder);
  for (const std::string& command : {"check " + folder.name("a.ply"), std::string("make --help")}) {
    const Said said =
        suture_program(command + " > /dev/full 2> " + folder.name("error") + "; exit $?");
    CHECK(said.exit == 2);
    CHECK_THAT(contents(folder / "error"), Contains("standard output"));
  }
}

TEST_CASE("a name that the file system refuses gives exit code 2 with its reason") {
  const Folder folder;
  write_balls(folder);
  const Said said = suture_program("resolve " + folder.name("a.ply") + " --cells 9 -o " +
                                   folder.name(std::string(300, 'x') + "/out.ply"));
  INFO(said.text);
  CHECK(said.exit == 2);
  CHECK_THAT(said.text, Contains("too long") && !Contains("filesystem error"));
}

TEST_CASE("a report adds up the seconds of a stage that ran twice") {
  SurgeryReport report;
  report.seconds = {{"cut", 1.5}, {"fill", 1}, {"cut", 2}};
  report.coincident_triangles = 7;
  const json written = to_json(report);
  CHECK(written["seconds"]["cut"] == 3.5);
  CHECK(written["seconds"]["fill"] == 1.0);
  CHECK(written["coincident_triangles"] == 7);
}

TEST_CASE("check says yes to a closed manifold and gives its measures") {
  const Folder folder;
  write_balls(folder);
  const Said table = suture_program("check " + folder.name("a.ply"));
  CHECK(table.exit == 0);
  CHECK_THAT(table.text, Contains("closed") && Contains("genus"));
  const Said said = suture_program("check --json " + folder.name("a.ply"));
  REQUIRE(said.exit == 0);
  const json list = json::parse(said.text);
  REQUIRE(list.size() == 1);
  CHECK(list[0]["audit"]["closed_manifold"] == true);
  CHECK(list[0]["measures"]["genus"] == 0);
  CHECK(list[0]["measures"]["components"] == 1);
  CHECK(list[0]["measures"]["self_intersecting_pairs"] == 0);
  CHECK(list[0]["measures"]["volume"].get<double>() ==
        Approx(volume(read_triangles(folder / "a.ply"))));
}

TEST_CASE("check says no to an open surface with exit code 1, and 2 to what is no mesh") {
  const Folder folder;
  write_triangles(folder / "open.ply", open_ball());
  const Said said = suture_program("check " + folder.name("open.ply"));
  CHECK(said.exit == 1);
  CHECK_THAT(said.text, Contains("3 border edges"));
  CHECK(suture_program("check --json " + folder.name("open.ply")).exit == 1);
  CHECK(suture_program("check " + folder.name("missing.ply")).exit == 2);
  CHECK(suture_program("check").exit == 2);
}

TEST_CASE("a mesh that a repair leaves empty passes neither check nor resolve") {
  const Folder folder;
  const std::string corners = "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\n";
  const std::string body = "f 1 3 2\nf 1 2 4\nf 2 3 4\nf 1 4 3\n";
  folder.write("twice.obj", corners + body + body);
  folder.write("pillow.obj", corners + "f 1 2 3\nf 1 3 2\n");
  CHECK(suture_program("check " + folder.name("twice.obj")).exit == 1);
  const Said one = suture_program("check --repair --json " + folder.name("twice.obj"));
  CHECK(one.exit == 0);
  CHECK(json::parse(one.text.substr(one.text.find("[\n")))[0]["measures"]["triangles"] == 4);
  const Said none = suture_program("check --repair " + folder.name("pillow.obj"));
  CHECK(none.exit == 1);
  CHECK_THAT(none.text, Contains("enclosed nothing") && Contains("the mesh is empty"));
  CHECK(suture_program("check --repair --json " + folder.name("pillow.obj")).exit == 1);
  const Said refused = suture_program("resolve --repair " + folder.name("pillow.obj") + " -o " +
                                      folder.name("out.ply") + " --cells 10");
  CHECK(refused.exit == 2);
  CHECK_THAT(refused.text, Contains("the mesh is empty"));
  CHECK(folder.files() == 2);
}

TEST_CASE("make writes a shape, and refuses what is no shape or no parameter") {
  const Folder folder;
  const std::string out = " -o " + folder.name("s.stl");
  CHECK(suture_program("make torus radius=2 tube_radius=0.5 edge_length=0.3" + out).exit == 0);
  CHECK(euler_characteristic(read_triangles(folder / "s.stl")) == 0);
  std::filesystem::remove(folder / "s.stl");
  for (const char* bad : {"tours", "torus radios=2", "torus radius=x", "torus radius=", "torus =2",
                          "torus radius=-1", "torus radius=nan", "torus radius=1 radius=2", ""}) {
    const Said said = suture_program(std::string("make ") + bad + out);
    INFO(bad << ": " << said.text);
    CHECK(said.exit == 2);
    CHECK(folder.files() == 0);
  }
}

TEST_CASE("run leaves meshes, pictures and a whole report") {
  const Folder folder;
  folder.write(
      "scene.toml",
      "[[bodies]]\nshape = \"sphere\"\nparameters = { frequency = 6, radius = 0.5, x = -0.6 }\n"
      "velocity = [1, 0, 0]\n"
      "[[bodies]]\nshape = \"sphere\"\nparameters = { frequency = 6, radius = 0.5, x = 0.6 }\n"
      "velocity = [-1, 0, 0]\n"
      "[motion]\nkind = \"bodies\"\n[tracker]\ncell_size = 0.12\n"
      "[time]\nstep = 0.05\nend = 0.3\n"
      "[meshes]\nevery = 3\nformat = \"off\"\n"
      "[pictures]\nat = [0.15]\nwidth = 160\nheight = 120\n");
  const Said said =
      suture_program("run " + folder.name("scene.toml") + " -o " + folder.name("out/deep"));
  INFO(said.text);
  REQUIRE(said.exit == 0);
  const json report = json::parse(contents(folder / "out/deep/report.json"));
  CHECK(report["summary"]["finished"] == true);
  CHECK(report["steps"].size() == 7);
  CHECK(report["remodels"].size() == 6);
  CHECK(report["improvements"].size() == 6);
  CHECK(report["steps"][0]["components"] == 2);
  CHECK(report["steps"][6]["components"] == 1);
  CHECK(report["summary"]["merges"] == 1);
  CHECK(report["audit"]["closed_manifold"] == true);
  for (const char* mesh : {"00000.off", "00003.off", "00006.off"})
    CHECK(audit(read_triangles(folder / ("out/deep/" + std::string(mesh)))).closed_manifold());
  for (const char* picture : {"00000.png", "00003.png", "00006.png"})
    CHECK(std::filesystem::exists(folder / ("out/deep/" + std::string(picture))));
}

TEST_CASE("a scene that is refused leaves nothing behind") {
  const Folder folder;
  folder.write("scene.toml",
               "[[bodies]]\nshape = \"sphere\"\n[tracker]\ncell_size = 1e-9\n"
               "[motion]\nkind = \"rest\"\n[time]\nstep = 1\nend = 1\n");
  const Said said =
      suture_program("run " + folder.name("scene.toml") + " -o " + folder.name("out"));
  INFO(said.text);
  CHECK(said.exit == 2);
  CHECK(folder.files() == 1);
  CHECK(suture_program("run missing.toml -o " + folder.name("out")).exit == 2);
  CHECK(suture_program("run " + folder.name("scene.toml")).exit == 2);
}

TEST_CASE(
    "a motion that leads out of the finite numbers stops with exit code 2 and a whole report") {
  const Folder folder;
  folder.write("scene.toml",
               "[[bodies]]\nshape = \"sphere\"\nparameters = { frequency = 2 }\n"
               "[tracker]\ncell_size = 0.5\n[motion]\nkind = \"stretch\"\nrate = 1e200\n"
               "[time]\nstep = 1\nend = 2\nremodel_every = 0\nimprove_every = 0\n");
  const Said said =
      suture_program("run " + folder.name("scene.toml") + " -o " + folder.name("out"));
  INFO(said.text);
  CHECK(said.exit == 2);
  CHECK_THAT(said.text, Contains("step 1"));
  const json report = json::parse(contents(folder / "out/report.json"));
  CHECK(report["summary"]["finished"] == false);
}
