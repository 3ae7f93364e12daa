// The mesh readers: refused by InvalidInput, or read to the last bit and fit for audit and repair.
#include "kernel/audit.h"
#include "kernel/errors.h"
#include "kernel/formats/formats.h"
#include "kernel/repair/repair.h"
#include "tests/fuzz/targets.h"
#include "tests/kernel/tiny.h"

namespace suture::fuzz {

namespace {

struct Format {
  const char* name;
  Triangles (*parse)(std::string_view, const std::string&);
  std::string (*format)(const Triangles&);
};
constexpr Format kObj{"obj", parse_obj, format_obj}, kOff{"off", parse_off, format_off},
    kPly{"ply", parse_ply, format_ply}, kStl{"stl", parse_stl, format_stl};

void require(bool holds, const char* format, const char* what) {
  if (!holds) throw Finding(std::string(format) + ": " + what);
}

void require_sound(const Triangles& surface, const Audit& found, const char* format) {
  require(found.finite(), format, "a coordinate that is not finite was accepted");
  require(found.indices_out_of_range == 0, format, "an index out of range was accepted");
  require(!surface.triangles.empty(), format, "a mesh without triangles was accepted");
}

/// Written and read again it is the same; one more way through text and one through binary.
void require_same_again(const Triangles& surface, const Format& own) {
  require(same_bits(own.parse(own.format(surface), "again"), surface), own.name,
          "writing and reading again gives other bits");
  const Format& other = own.parse == parse_ply ? kOff : kPly;
  require(same_bits(other.parse(other.format(surface), "again"), surface), own.name,
          "the way through another format gives other bits");
}

void require_mended_once(Triangles surface, const Audit& found, const char* format) {
  const RepairReport once = repair(surface);
  if (found.closed_manifold())
    require(once.degenerate_triangles + once.duplicate_triangles + once.welded_vertices +
                    once.turned_triangles + once.split_vertices ==
                0,
            format, "a closed manifold was repaired");
  const Audit mended = audit(surface);
  require(mended.degenerate_triangles + mended.duplicate_triangles + mended.isolated_vertices +
                  mended.indices_out_of_range + mended.non_finite_vertices ==
              0,
          format, "repair left what it should drop");
  const Triangles after = surface;
  require(!repair(surface).changed() && same_bits(surface, after), format,
          "a second repair changes what the first one left");
}

void read(std::string_view bytes, const Format& own) {
  Triangles surface;
  try {
    surface = own.parse(bytes, "fuzzed");
  } catch (const InvalidInput& refusal) {
    require(std::string_view(refusal.what()).starts_with("fuzzed"), own.name,
            "a refusal does not name the file");
    return;
  }
  const Audit found = audit(surface);
  require_sound(surface, found, own.name);
  require_same_again(surface, own);
  require_mended_once(std::move(surface), found, own.name);
}

}  // namespace

void read_obj(std::string_view bytes) { read(bytes, kObj); }
void read_off(std::string_view bytes) { read(bytes, kOff); }
void read_ply(std::string_view bytes) { read(bytes, kPly); }
void read_stl(std::string_view bytes) { read(bytes, kStl); }

}  // namespace suture::fuzz
