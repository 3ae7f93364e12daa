#include "kernel/formats/mesh_io.h"

#include <catch2/catch.hpp>
#include <fstream>
#include <limits>

#include "kernel/audit.h"
#include "kernel/errors.h"
#include "kernel/files.h"
#include "kernel/measure/measures.h"
#include "tests/kernel/folder.h"
#include "tests/kernel/formats/samples.h"
#include "tests/kernel/tiny.h"

using namespace suture;
using Catch::Matchers::Contains;

namespace {

// A closed surface of awkward doubles.
Triangles awkward() {
  Triangles s = cube(0.1, 1.0 / 3);
  s.positions[0] = {-0.0, 5e-324, 1e300};
  s.positions[1] = {std::numeric_limits<double>::max(), std::numeric_limits<double>::min(),
                    -1e-310};
  s.positions[2] = {std::nextafter(1.0, 2.0), -std::numeric_limits<double>::denorm_min(), 1e22};
  s.positions[3] = {0.1 + 0.2, 123456789012345678.0, -1e-5};
  return s;
}

}  // namespace

TEST_CASE("each extension in the list is known in either case, and no other is") {
  for (const std::string_view extension : kMeshExtensions) {
    CHECK(has_mesh_extension("a" + std::string(extension)));
    CHECK_THAT(mesh_extensions_in_words(), Contains(std::string(extension)));
  }
  CHECK(has_mesh_extension("folder.d/A.StL"));
  for (const char* other : {"a", "a.xyz", "a.ply.gz", ".ply", ""})
    CHECK_FALSE(has_mesh_extension(other));
  CHECK(mesh_extensions_in_words() == ".ply, .obj, .off or .stl");
}

TEST_CASE("what is written reads back with the same bits") {
  const TemporaryFolder folder;
  for (const char* name : {"a.obj", "a.off", "a.ply", "A.OFF"})
    for (const Triangles& s : {awkward(), tetrahedron(), sheet(7, -0.0)}) {
      INFO(name);
      write_triangles(folder / name, s);
      CHECK(same_bits(read_triangles(folder / name), s));
    }
}

TEST_CASE("STL gives back the same bits, with vertices in the order of use") {
  const TemporaryFolder folder;
  write_triangles(folder / "a.stl", awkward());
  const Triangles back = read_triangles(folder / "a.stl");
  CHECK(back.positions.size() == 8);
  CHECK(audit(back).closed_manifold());
  CHECK(same_bits(soup(back), soup(awkward())));
}

TEST_CASE("writing leaves nothing else in the folder, and replaces what was there") {
  const TemporaryFolder folder;
  write_triangles(folder / "a.ply", cube(0, 1));
  write_triangles(folder / "a.ply", tetrahedron());
  CHECK(same_bits(read_triangles(folder / "a.ply"), tetrahedron()));
  CHECK(std::distance(std::filesystem::directory_iterator(folder.path()), {}) == 1);
}

TEST_CASE("writing goes through symbolic links, and straight to a device") {
  const TemporaryFolder folder;
  write_file(folder / "real", "old");
  std::filesystem::create_symlink("real", folder / "link");
  std::filesystem::create_symlink("not-yet", folder / "dangling");
  std::filesystem::create_symlink("/dev/null", folder / "null");
  write_file(folder / "link", "new");
  write_file(folder / "dangling", "made");
  write_file(folder / "null", "gone");
  CHECK(read_file(folder / "real") == "new");
  CHECK(read_file(folder / "not-yet") == "made");
  for (const char* link : {"link", "dangling", "null"})
    CHECK(std::filesystem::is_symlink(folder / link));
  CHECK(std::filesystem::is_character_file("/dev/null"));
  CHECK_THROWS_AS(write_file("/dev/full", "x"), InvalidInput);
  CHECK(std::filesystem::is_character_file("/dev/full"));
}

TEST_CASE("what cannot be written is refused and leaves no file behind") {
  const TemporaryFolder folder;
  CHECK_THROWS_WITH(write_triangles(folder / "none" / "a.obj", cube(0, 1)),
                    Contains("cannot be written") && Contains("folder"));
  CHECK_THROWS_WITH(write_triangles(folder / "a.xyz", cube(0, 1)), Contains("'.xyz'"));
  CHECK_THROWS_WITH(write_triangles(folder / "a", cube(0, 1)), Contains("no extension"));
  std::filesystem::create_directory(folder / "dir.obj");
  CHECK_THROWS_WITH(write_triangles(folder / "dir.obj", cube(0, 1)), Contains("folder"));
  Triangles broken = cube(0, 1);
  broken.triangles[3][1] = 99;
  CHECK_THROWS_WITH(write_triangles(folder / "a.stl", broken), Contains("triangle 3"));
  broken = cube(0, 1);
  broken.positions[5][2] = std::numeric_limits<double>::quiet_NaN();
  CHECK_THROWS_WITH(write_triangles(folder / "a.obj", broken), Contains("vertex 5"));
  CHECK(std::distance(std::filesystem::directory_iterator(folder.path()), {}) == 1);
}

TEST_CASE("missing, empty and unreadable files are refused by name") {
  const TemporaryFolder folder;
  CHECK_THROWS_WITH(read_triangles(folder / "no.obj"),
                    Contains("no.obj") && Contains("no such file"));
  CHECK_THROWS_WITH(read_triangles(folder.path() / ""), Contains("extension"));
  std::filesystem::create_directory(folder / "d.ply");
  CHECK_THROWS_WITH(read_triangles(folder / "d.ply"), Contains("folder"));
  CHECK_THROWS_WITH(read_text(folder, "a.gltf", "{}"), Contains("'.gltf'"));
  for (const char* name : {"e.obj", "e.off", "e.ply", "e.stl"})
    CHECK_THROWS_WITH(read_text(folder, name, ""), Contains("empty"));
  CHECK_THROWS_WITH(read_text(folder, "p.obj", "v 0 0 0\n"),
                    Contains("empty") && Contains("0 faces"));
  CHECK_THROWS_WITH(read_text(folder, "p.off", "OFF 0 0 0\n"), Contains("empty"));
}

TEST_CASE("bodies that touch along an edge or a face, or do in 32 bits, are not written as STL") {
  const TemporaryFolder folder;
  for (const Point& shift : {Point(1, 0, 0), Point(1, 1, 0), Point(1 + 1e-12, 1, 0)}) {
    Triangles other = cube(0, 1);
    for (Point& p : other.positions) p += shift;
    const Triangles both = joined(cube(0, 1), other);
    CHECK_THROWS_WITH(write_triangles(folder / "both.stl", both),
                      Contains("both.stl") && Contains("32 bits") && Contains("write PLY"));
    CHECK_FALSE(std::filesystem::exists(folder / "both.stl"));
    write_triangles(folder / "both.ply", both);
    CHECK(read_triangles(folder / "both.ply") == both);
  }
}
