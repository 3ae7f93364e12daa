// Damaged files: every prefix of small valid ones, and thousands of random mutations.
#include <catch2/catch.hpp>

#include "kernel/audit.h"
#include "kernel/errors.h"
#include "kernel/formats/formats.h"
#include "tests/kernel/tiny.h"

using namespace suture;

namespace {

struct Sample {
  const char* name;
  Triangles (*parse)(std::string_view, const std::string&);
  std::string bytes;
};

std::string binary_stl(const Triangles& s) {
  std::string bytes(80, 'x');
  const auto put = [&](auto x) { bytes.append(reinterpret_cast<const char*>(&x), sizeof x); };
  put(static_cast<std::uint32_t>(s.triangles.size()));
  for (const Triangle& t : s.triangles) {
    for (int i = 0; i < 3; ++i) put(0.0F);
    for (const std::uint32_t v : t)
      for (const double x : s.positions[v]) put(static_cast<float>(x));
    put(std::uint16_t{0});
  }
  return bytes;
}

std::vector<Sample> samples() {
  const Triangles s = tetrahedron();
  const std::string text_ply =
      "ply\nformat ascii 1.0\nelement vertex 4\nproperty float x\nproperty float y\nproperty float "
      "z\nproperty list uchar int more\nelement face 2\nproperty list uchar int vertex_indices\n"
      "end_header\n0 0 0 1 7\n1 0 0 0\n1 1 0 0\n0 1 0 2 5 5\n4 0 1 2 3\n3 0 2 1\n";
  return {{"obj", parse_obj, format_obj(s) + "vt 0 0\nf 1/1 2//1 -1\nf 1 2 3 4\n"},
          {"off", parse_off, format_off(s)},
          {"binary ply", parse_ply, format_ply(s)},
          {"text ply", parse_ply, text_ply},
          {"text stl", parse_stl, format_stl(s)},
          {"binary stl", parse_stl, binary_stl(s)}};
}

// Whatever a reader accepts has finite coordinates, indices in range, and triangles.
bool accepted_soundly(const Sample& sample, const std::string& bytes) {
  try {
    const Triangles s = sample.parse(bytes, "damaged");
    const Audit a = audit(s);
    REQUIRE(a.finite());
    REQUIRE(a.indices_out_of_range == 0);
    REQUIRE(!s.triangles.empty());
    return true;
  } catch (const InvalidInput& refusal) {
    REQUIRE(std::string(refusal.what()).starts_with("damaged"));
    return false;
  }
}

}  // namespace

TEST_CASE("every prefix of a valid file is read soundly or refused") {
  for (const Sample& sample : samples()) {
    INFO(sample.name);
    CHECK(accepted_soundly(sample, sample.bytes));
    for (std::size_t n = 0; n < sample.bytes.size(); ++n)
      accepted_soundly(sample, sample.bytes.substr(0, n));
  }
}

TEST_CASE("a file with counts that ends early is never accepted") {
  for (const Sample& sample : samples()) {
    if (sample.parse == parse_obj) continue;  // an OBJ says nowhere how long it is
    INFO(sample.name);
    const std::size_t end = sample.bytes.find_last_not_of('\n');
    for (std::size_t n = 0; n < end; ++n) {
      const bool last_number_cut =
          std::string_view(sample.name) == "off" || std::string_view(sample.name) == "text ply";
      if (last_number_cut && n + 1 >= end) continue;  // "12" cut to "1" is a number still
      if (std::string_view(sample.name) == "text stl" &&
          sample.bytes.substr(0, n).find("endsolid") != std::string::npos)
        continue;  // only the name at the end is cut
      INFO(n);
      CHECK_FALSE(accepted_soundly(sample, sample.bytes.substr(0, n)));
    }
  }
}

TEST_CASE("2000 random mutations of each format are read soundly or refused") {
  Dice dice(20090801);
  for (const Sample& sample : samples()) {
    INFO(sample.name);
    std::size_t accepted = 0;
    for (int round = 0; round < 2000; ++round) {
      std::string bytes = sample.bytes;
      for (std::size_t k = 1 + dice.below(4); k > 0; --k) {
        const std::size_t at = dice.below(bytes.size());
        switch (dice.below(4)) {
          case 0:
            bytes[at] = static_cast<char>(dice.below(256));
            break;
          case 1:
            bytes[at] = "0123456789-+.eE \n/nan"[dice.below(21)];
            break;
          case 2:
            bytes.erase(at, 1 + dice.below(8));
            break;
          default: {
            const std::size_t from = dice.below(bytes.size());
            bytes.insert(at, bytes.substr(from, dice.below(12)));
          }
        }
        if (bytes.empty()) bytes = " ";
      }
      accepted += accepted_soundly(sample, bytes) ? 1 : 0;
    }
    CHECK(accepted < 2000);
  }
}
