// PLY files, good and faulty, as text and binary.
#include <catch2/catch.hpp>

#include "kernel/formats/formats.h"
#include "tests/kernel/formats/samples.h"
#include "tests/kernel/tiny.h"

using namespace suture;
using Catch::Matchers::Contains;

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
