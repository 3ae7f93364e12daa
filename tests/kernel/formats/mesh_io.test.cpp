#include "kernel/formats/mesh_io.h"

#include <catch2/catch.hpp>
#include <fstream>
#include <limits>

#include "kernel/audit.h"
#include "kernel/errors.h"
#include "kernel/files.h"
#include "kernel/formats/formats.h"
#include "kernel/measure/measures.h"
#include "tests/kernel/folder.h"
#include "tests/kernel/tiny.h"

using namespace suture;
using Catch::Matchers::Contains;

namespace {

Triangles read_text(const TemporaryFolder& folder, const std::string& name,
                    const std::string& text) {
  write_file(folder / name, text);
  return read_triangles(folder / name);
}

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

std::string header(const std::string& format, int vertices, int faces) {
  return "ply\nformat " + format + " 1.0\ncomment made by a test\nelement vertex " +
         std::to_string(vertices) +
         "\nproperty double x\nproperty double y\nproperty double z\nelement face " +
         std::to_string(faces) + "\nproperty list uchar int vertex_indices\nend_header\n";
}

const std::string kObj = "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 3 2\nf 1 2 4\nf 2 3 4\nf 1 4 3\n";
const std::string kOff =
    "OFF\n4 4 6\n0 0 0\n1 0 0\n0 1 0\n0 0 1\n3 0 2 1\n3 0 1 3\n3 1 2 3\n3 0 3 2\n";
const std::string kPly =
    header("ascii", 4, 4) + "0 0 0\n1 0 0\n0 1 0\n0 0 1\n3 0 2 1\n3 0 1 3\n3 1 2 3\n3 0 3 2\n";

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

TEST_CASE("OBJ: slashes, negative indices, polygons, groups, joined lines and CRLF are read") {
  const TemporaryFolder folder;
  const Triangles s = read_text(folder, "a.obj",
                                "# cube\r\nmtllib x.mtl\r\no thing\r\nv 0 0 0\r\nv 1 0 0 1.0\r\n"
                                "v 1 1 0 0.5 0.5 0.5\r\nv 0 1 0\r\nvt 0 0\r\nvn 0 0 1\r\ns off\r\n"
                                "g all\r\nf 1/1/1 2//1 3/1 \\\r\n 4\r\nf -4 -3 -1 # last\r\n");
  CHECK(s.positions.size() == 4);
  CHECK(s.triangles == std::vector<Triangle>{{0, 1, 2}, {0, 2, 3}, {0, 1, 3}});
}

TEST_CASE("OBJ: faults are refused with their line") {
  const TemporaryFolder folder;
  const auto refused = [&](const std::string& text, const std::string& why) {
    INFO(text);
    CHECK_THROWS_WITH(read_text(folder, "a.obj", text), Contains(why));
    CHECK_THROWS_AS(read_text(folder, "a.obj", text), InvalidInput);
  };
  refused("v 0 0 0\nv 1 x 0\n", "a.obj:2: y of a vertex is not a number: 'x'");
  refused("v 0 0 0\nv 1\n", "a.obj:2: y of a vertex is missing");
  refused("v 0 0 0\nv 1 0 0\nv 0 nan 0\nv inf 0 0\nf 1 2 3\n", "a.obj:3: vertex 3");
  refused("v 0 0 0\nv 1 0 0\nv 0 1e999 0\nf 1 2 3\n", "not finite (1 such");
  refused("v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\nf 1 2 4\nf 7 8 9\n",
          "a.obj:5: face 2 has the vertex index 4, counted from 1,");
  refused("v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\nf 1 2 4\nf 7 8 9\n", "4 such in all");
  refused("v 0 0 0\nv 1 0 0\nv 0 1 0\nf -1 -2 -4\n", "a.obj:4: a face has the vertex index -4");
  refused("v 0 0 0\nv 1 0 0\nv 0 1 0\nf 0 1 2\n", "a.obj:4");
  refused("v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2\n", "a.obj:4: face 1 has 2 vertices");
  refused("v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3.5\n", "'3.5'");
  refused("v 0 0 0\nv 1 0 0\nv 0 1 0\nf 99999999999999999999 1 2\n", "a.obj:4");
  refused(kObj + "hello\n", "a.obj:9: 'hello' is not a keyword");
}

TEST_CASE("numbers beyond the doubles become zero where they are small") {
  const TemporaryFolder folder;
  const Triangles s =
      read_text(folder, "a.obj", "v 1e-400 -1e-4000 +1.5\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
  CHECK(s.positions[0] == Point(0, 0, 1.5));
}

TEST_CASE("OFF: comments, colours, normals and polygons are read") {
  const TemporaryFolder folder;
  CHECK(same_bits(read_text(folder, "a.off", kOff), tetrahedron()));
  CHECK(same_bits(read_text(folder, "b.off", "# top\nOFF 4 4 6 # counts\n" + kOff.substr(10)),
                  tetrahedron()));
  const Triangles s =
      read_text(folder, "c.off",
                "CNOFF\n4 1 0\n0 0 0 0 0 1 255 0 0 255\n1 0 0 0 0 1 1 1 1 1\n"
                "1 1 0 0 0 1 1 1 1 1\n\n0 1 0 0 0 1 1 1 1 1\n4 0 1 2 3 0.5 0.5 0.5\n");
  CHECK(s.triangles.size() == 2);
  CHECK(s.positions[2] == Point(1, 1, 0));
}

TEST_CASE("OFF: faults are refused with their line") {
  const TemporaryFolder folder;
  const auto refused = [&](const std::string& text, const std::string& why) {
    INFO(text);
    CHECK_THROWS_WITH(read_text(folder, "a.off", text), Contains(why));
  };
  refused("4 4 6\n0 0 0\n", "does not start with OFF");
  refused("OFF BINARY\n", "a.off:1");
  refused("OFF\n-4 4 0\n", "'-4'");
  refused("OFF\n99999999999999 1 0\n0 0 0\n", "after 1 of 99999999999999 vertices");
  refused(kOff.substr(0, kOff.size() - 8), "after 3 of 4 faces");
  refused(kOff + "3 0 1 2\n", "a.off:11: there is more after the last face");
  refused("OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 -2\n", "a.off:6: face 0");
  refused("OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1\n", "a vertex of a face is missing");
  refused("OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n-3 0 1\n", "a.off:6");
}

TEST_CASE("PLY: text and both byte orders give the same mesh, whatever else they carry") {
  const TemporaryFolder folder;
  CHECK(same_bits(read_text(folder, "a.ply", kPly), tetrahedron()));
  std::string crlf;
  for (const char c : kPly) crlf += c == '\n' ? std::string("\r\n") : std::string(1, c);
  CHECK(same_bits(read_text(folder, "b.ply", crlf), tetrahedron()));
  const std::string little = format_ply(tetrahedron());
  const std::size_t body = little.find("end_header\n") + 11;
  std::string big = little;
  big.replace(big.find("little"), 6, "big");
  std::size_t at = big.find("end_header\n") + 11;
  for (int i = 0; i < 12; ++i, at += 8) std::reverse(big.begin() + at, big.begin() + at + 8);
  for (int i = 0; i < 12; ++i, at += 4) {
    if (i % 3 == 0) ++at;
    std::reverse(big.begin() + at, big.begin() + at + 4);
  }
  CHECK(body > 0);
  CHECK(same_bits(read_text(folder, "c.ply", big), tetrahedron()));
}

TEST_CASE("PLY: other elements, properties and lists are passed over") {
  const TemporaryFolder folder;
  const Triangles s = read_text(
      folder, "a.ply",
      "ply\nformat ascii 1.0\nobj_info x\nelement camera 1\nproperty float f\nproperty list uchar "
      "float m\nelement face 1\nproperty uchar red\nproperty list uint8 uint32 vertex_index\n"
      "element vertex 4\nproperty float z\nproperty list int short n\nproperty float y\nproperty "
      "int x\nelement nothing 1000000000000\nend_header\n0.5 2 1 1\n255 4 0 1 2 3\n0 0 0 0\n"
      "0 1 5 0 1\n0 2 5 5 1 1\n0 0 1 0\n");
  CHECK(s.triangles.size() == 2);
  CHECK(s.positions[2] == Point(1, 1, 0));
}

TEST_CASE("PLY: faults are refused with their line or element") {
  const TemporaryFolder folder;
  const auto refused = [&](const std::string& text, const std::string& why) {
    INFO(text);
    CHECK_THROWS_WITH(read_text(folder, "a.ply", text), Contains(why));
  };
  const std::string three = "0 0 0\n1 0 0\n0 1 0\n";
  refused("plx\n", "does not start with 'ply'");
  refused("ply\nformat ascii 1.0\n", "ends within its header");
  refused("ply\nformat morse 1.0\n", "'morse'");
  refused("ply\nelement vertex x\n", "a.ply:2");
  refused("ply\nformat ascii 1.0\nelement vertex 3\nproperty double x\nend_header\n",
          "no coordinate y");
  refused("ply\nformat ascii 1.0\nend_header\n", "0 times");
  refused(header("ascii", 3, 1) + three + "3 0 1\n", "a.ply:14");
  refused(header("ascii", 3, 1) + three + "3 0 1 77\n", "a.ply:14: face 0");
  refused(header("ascii", 3, 1) + three + "3 0 1 -1\n", "vertex index -1");
  refused(header("ascii", 3, 1) + three + "3 0 1 2 9\n", "more values");
  refused(header("ascii", 3, 2) + three + "3 0 1 2\n", "ends before 'face' 1 of 2");
  refused(header("ascii", 3, 1) + three + "3 0 1 2\n3 0 1 2\n", "a.ply:15: there is more");
  refused(header("ascii", 3, 1) + "0 0 0\n1 0 nan\n0 1 0\n3 0 1 2\n", "a.ply:12: vertex 1");
  const std::string binary = format_ply(tetrahedron());
  refused(binary.substr(0, binary.size() - 1), "ends within 'face' 3 of 4");
  refused(binary + "x", "1 bytes after the last element");
  std::string not_a_number = binary;
  const std::size_t body = binary.find("end_header\n") + 11;
  not_a_number.replace(body + 24 + 6, 2, "\xF8\x7F");
  refused(not_a_number, "vertex 1 has a coordinate that is not finite");
  std::string negative = binary;
  negative.replace(negative.find("uint"), 4, "int");
  negative.replace(body - 1 + 4 * 24 + 1, 4, "\xFF\xFF\xFF\xFF");
  refused(negative, "face 0 has the vertex index -1");
}

TEST_CASE("STL: binary is told from text by its size, and points are welded") {
  const TemporaryFolder folder;
  std::string bytes = "solid yet binary";
  bytes.resize(80, ' ');
  const Triangles s = tetrahedron();
  const auto put = [&](auto x) { bytes.append(reinterpret_cast<const char*>(&x), sizeof x); };
  put(std::uint32_t{4});
  for (const Triangle& t : s.triangles) {
    for (int i = 0; i < 3; ++i) put(0.0F);
    for (const std::uint32_t v : t)
      for (const double x : s.positions[v]) put(static_cast<float>(x));
    put(std::uint16_t{7});
  }
  const Triangles back = read_text(folder, "a.stl", bytes);
  CHECK(back.positions.size() == 4);
  CHECK(audit(back).closed_manifold());
  CHECK(volume(back) == volume(s));
  CHECK_THROWS_WITH(read_text(folder, "a.stl", bytes.substr(0, 200)),
                    Contains("200 bytes where 4 facets take 284"));
}

TEST_CASE("STL: degenerate facets are kept for the audit to report") {
  const TemporaryFolder folder;
  Triangles s = tetrahedron();
  s.triangles.push_back({1, 1, 2});
  write_triangles(folder / "a.stl", s);
  CHECK(audit(read_triangles(folder / "a.stl")).degenerate_triangles == 1);
}

TEST_CASE("STL: faults in text are refused with their line") {
  const TemporaryFolder folder;
  const auto refused = [&](const std::string& text, const std::string& why) {
    INFO(text);
    CHECK_THROWS_WITH(read_text(folder, "a.stl", text), Contains(why));
  };
  const std::string text = format_stl(tetrahedron());
  refused("facet\n", "neither text that starts with 'solid'");
  refused("solid a\nfacet normal 0 0 1\nouter loop\nvertex 0 0 zero\n", "a.stl:4");
  refused("solid a\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nendloop\n",
          "'endloop' stands where 'vertex' should");
  refused(text.substr(0, text.size() - 16), "without 'endsolid'");
  refused(text + "more\n", "more after 'endsolid'");
  refused("solid\nendsolid\n", "the mesh is empty");
}

TEST_CASE("concave polygons are triangulated without folds") {
  const TemporaryFolder folder;
  // An L seen from above and from below, in each of its six rotations, and on its side.
  const double at[6][2] = {{0, 0}, {2, 0}, {2, 1}, {1, 1}, {1, 2}, {0, 2}};
  for (int start = 0; start < 6; ++start)
    for (const bool up : {true, false}) {
      std::string text;
      for (const auto& p : at)
        text += "v " + std::to_string(p[0]) + " 0 " + std::to_string(p[1]) + "\n";
      text += "f";
      for (int i = 0; i < 6; ++i) text += " " + std::to_string((start + (up ? i : 6 - i)) % 6 + 1);
      const Triangles s = read_text(folder, "l.obj", text + "\n");
      CHECK(s.triangles.size() == 4);
      CHECK(area(s) == 3);  // a fold would count twice
    }
}
