// Scan conversion of the mesh: cost follows the number of crossings [§5].
#include "surgery/detect/crossings.h"

#include <unistd.h>

#include <algorithm>
#include <cstdio>
#include <string>

#include "kernel/errors.h"
#include "kernel/union_find.h"

namespace suture::surgery {

namespace {

void cross_edges(const Incidence& mesh, const ShiftedLattice& on, Crossings& out) {
  out.edge_begin.reserve(mesh.edges.size() + 1);
  for (const auto& [p, q] : mesh.edges) {
    out.edge_begin.push_back(static_cast<std::uint32_t>(out.edge_crossings.size()));
    if (out.vertex_cell[p] == out.vertex_cell[q]) continue;
    edge_path({mesh.positions[p], mesh.positions[q], out.vertex_cell[p], out.vertex_cell[q]}, on,
              out.edge_crossings);
  }
  out.edge_begin.push_back(static_cast<std::uint32_t>(out.edge_crossings.size()));
}

/// Edge crossings joined along curves in lattice faces: a curve that reaches no lattice line is a
/// loop in its face.
class FaceCurves {
 public:
  explicit FaceCurves(std::size_t n) : curves_(n), open_(n, 0) {}
  void unite(std::uint32_t a, std::uint32_t b) {
    const char open = open_[curves_.root(a)];
    open_[curves_.join_to(a, b)] |= open;
  }
  void mark_open(std::uint32_t a) { open_[curves_.root(a)] = 1; }
  /// Whether the crossing stands for a curve that is a loop.
  bool is_loop(std::uint32_t a) { return curves_.root(a) == a && open_[a] == 0; }

 private:
  UnionFind curves_;
  std::vector<char> open_;
};

/// Crosses triangles with lattice lines, plane by plane, and finds the loops in faces on the way.
class TriangleScan {
 public:
  /// \pre `out` has its edge crossings
  TriangleScan(const Incidence& mesh, const ShiftedLattice& on, Crossings& out)
      : mesh_(mesh), on_(on), out_(out), curves_(out.edge_crossings.size()) {}

  void cross(std::uint32_t t, Lines lines) {
    const Triangle& v = mesh_.triangles[t];
    const LatticeTriangle shape =
        lattice_triangle(mesh_.positions[v[0]], mesh_.positions[v[1]], mesh_.positions[v[2]]);
    const int axes = lines == Lines::all ? 3 : 1;  // lines along z are recorded in planes across x
    for (int axis = 0; axis < axes; ++axis) {
      planes_.find({mesh_, on_, out_}, t, axis);
      for (const PlaneEnds& ends : planes_.ends) {
        const LatticeId from = out_.edge_crossings[ends.up].face,
                        to = out_.edge_crossings[ends.down].face;
        if (from == to) {
          curves_.unite(ends.up, ends.down);
          continue;
        }
        curves_.mark_open(ends.up);
        curves_.mark_open(ends.down);
        steps_.clear();
        plane_path({shape, axis, unpack(from), unpack(to)}, on_, steps_);
        record_lines(t, prev_axis(axis));
      }
    }
  }

  void record_loops() {
    for (std::uint32_t c = 0; c < out_.edge_crossings.size(); ++c)
      if (curves_.is_loop(c))
        out_.loop_faces[out_.edge_crossings[c].axis].push_back(out_.edge_crossings[c].face);
  }

 private:
  /// A line is met in two planes; the cyclic one records it.
  void record_lines(std::uint32_t t, int along) {
    for (const LineStep& s : steps_)
      if (s.axis == along)
        out_.line_crossings.push_back(
            {s.edge, t, static_cast<std::int8_t>(s.axis), static_cast<std::int8_t>(-s.normal)});
  }

  const Incidence& mesh_;
  const ShiftedLattice& on_;
  Crossings& out_;
  FaceCurves curves_;
  std::vector<LineStep> steps_;
  TrianglePlanes planes_;
};

/// About how many crossings there are: exact for mesh edges, by projected area (in cells) for
/// lattice lines. In doubles, so that it cannot itself overflow.
double expected_crossings(const Triangles& surface, const Lattice& lattice) {
  Point per_unit;
  for (int a = 0; a < 3; ++a)
    per_unit[a] = lattice.cells(a) / (lattice.plane(a, lattice.cells(a)) - lattice.plane(a, 0));
  auto cell = [&](std::uint32_t v) -> Point { return surface.positions[v].cwiseProduct(per_unit); };
  double edges = 0, lines = 0;
  for (const Triangle& t : surface.triangles) {
    const Point a = cell(t[0]), b = cell(t[1]), c = cell(t[2]);
    edges += ((b - a).lpNorm<1>() + (c - b).lpNorm<1>() + (a - c).lpNorm<1>()) / 2;
    lines += (b - a).cross(c - a).lpNorm<1>() / 2;
  }
  return edges + lines;
}

}  // namespace

void TrianglePlanes::find(const CrossedMesh& in, std::uint32_t triangle, int axis) {
  const Incidence& mesh = in.mesh;
  const Crossings& crossings = in.crossings;
  const Triangle& v = mesh.triangles[triangle];
  const auto [low, high] =
      std::minmax({crossings.vertex_cell[v[0]][axis], crossings.vertex_cell[v[1]][axis],
                   crossings.vertex_cell[v[2]][axis]});
  first = low + 1;
  ends.assign(static_cast<std::size_t>(high - low), {});
  if (high == low) return;
  for (std::size_t k = 0; k < 3; ++k) {
    const std::uint32_t e = mesh.triangle_edges[triangle][k];
    const bool up = crossings.vertex_cell[v[k]][axis] < crossings.vertex_cell[v[(k + 1) % 3]][axis];
    for (std::uint32_t c = crossings.edge_begin[e]; c < crossings.edge_begin[e + 1]; ++c) {
      if (crossings.edge_crossings[c].axis != axis) continue;
      const int plane = unpack(crossings.edge_crossings[c].face)[axis];
      PlaneEnds& here = ends[static_cast<std::size_t>(plane - first)];
      (up ? here.up : here.down) = c;
    }
  }
  for (const PlaneEnds& here : ends)
    if (here.up == kNone || here.down == kNone)
      throw InternalFailure("crossings", "triangle " + std::to_string(triangle) +
                                             " does not pass a plane once up and once down");
}

Crossings find_crossings(const Incidence& mesh, const ShiftedLattice& on, Lines lines) {
  Crossings out;
  out.vertex_cell.reserve(mesh.positions.size());
  for (const Point& p : mesh.positions) out.vertex_cell.push_back(on.lattice.cell_of(p));
  cross_edges(mesh, on, out);

  TriangleScan scan(mesh, on, out);
  out.triangle_begin.reserve(mesh.triangles.size() + 1);
  for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t) {
    out.triangle_begin.push_back(static_cast<std::uint32_t>(out.line_crossings.size()));
    const Triangle& v = mesh.triangles[t];
    if (out.vertex_cell[v[0]] == out.vertex_cell[v[1]] &&
        out.vertex_cell[v[1]] == out.vertex_cell[v[2]])
      continue;
    scan.cross(t, lines);
  }
  out.triangle_begin.push_back(static_cast<std::uint32_t>(out.line_crossings.size()));
  if (lines == Lines::all) scan.record_loops();
  return out;
}

void require_crossings_fit(const Triangles& surface, const Lattice& lattice) {
  // Crossings, windings, cells and cut together: 120 to 180 bytes measured on bodies of 10⁵ to 10⁷.
  constexpr double kBytesEach = 200;
  constexpr double kMostIndices = 4294967295.0;
  const double count = expected_crossings(surface, lattice);
  const double memory =
      static_cast<double>(sysconf(_SC_PHYS_PAGES)) * static_cast<double>(sysconf(_SC_PAGESIZE));
  if (count < kMostIndices && count * kBytesEach < memory) return;
  char text[256];
  std::snprintf(
      text, sizeof text,
      "the surface would cross this lattice about %.3g times, which takes %.3g GB; this "
      "machine has %.3g GB, and at most %.3g crossings can be numbered; choose a larger cell",
      count, count * kBytesEach / 1e9, memory / 1e9, kMostIndices);
  throw InvalidInput(text);
}

}  // namespace suture::surgery
