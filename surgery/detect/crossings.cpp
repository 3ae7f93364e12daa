// Scan conversion of the mesh: cost follows the number of crossings [§5].
#include "surgery/detect/crossings.h"

#include <algorithm>
#include <string>

#include "kernel/errors.h"
#include "kernel/union_find.h"

namespace suture::surgery {

namespace {

void cross_edges(const Incidence& mesh, const Lattice& lattice, const Oracle& oracle,
                 Crossings& out) {
  out.edge_begin.reserve(mesh.edges.size() + 1);
  for (const auto& [p, q] : mesh.edges) {
    out.edge_begin.push_back(static_cast<std::uint32_t>(out.edge_crossings.size()));
    if (out.vertex_cell[p] == out.vertex_cell[q]) continue;
    edge_path({mesh.positions[p], mesh.positions[q], out.vertex_cell[p], out.vertex_cell[q]},
              lattice, oracle, out.edge_crossings);
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

void cross_triangle(const Incidence& mesh, std::uint32_t t, const Lattice& lattice,
                    const Oracle& oracle, Lines lines, Crossings& out, FaceCurves& curves,
                    std::vector<LineStep>& steps, TrianglePlanes& planes) {
  const Triangle& v = mesh.triangles[t];
  const LatticeTriangle shape =
      lattice_triangle(mesh.positions[v[0]], mesh.positions[v[1]], mesh.positions[v[2]]);
  const int axes = lines == Lines::all ? 3 : 1;  // lines along z are recorded in planes across x
  for (int axis = 0; axis < axes; ++axis) {
    triangle_planes(mesh, out, t, axis, planes);
    for (const PlaneEnds& ends : planes.ends) {
      const LatticeId from = out.edge_crossings[ends.up].face,
                      to = out.edge_crossings[ends.down].face;
      if (from == to) {
        curves.unite(ends.up, ends.down);
        continue;
      }
      curves.mark_open(ends.up);
      curves.mark_open(ends.down);
      steps.clear();
      plane_path(shape, axis, unpack(from), unpack(to), lattice, oracle, steps);
      for (const LineStep& s : steps)  // a line is met in two planes; the cyclic one records it
        if (s.axis == prev_axis(axis))
          out.line_crossings.push_back(
              {s.edge, t, static_cast<std::int8_t>(s.axis), static_cast<std::int8_t>(-s.normal)});
    }
  }
}

}  // namespace

void triangle_planes(const Incidence& mesh, const Crossings& crossings, std::uint32_t triangle,
                     int axis, TrianglePlanes& planes) {
  const Triangle& v = mesh.triangles[triangle];
  const auto [low, high] =
      std::minmax({crossings.vertex_cell[v[0]][axis], crossings.vertex_cell[v[1]][axis],
                   crossings.vertex_cell[v[2]][axis]});
  planes.first = low + 1;
  planes.ends.assign(static_cast<std::size_t>(high - low), {});
  if (high == low) return;
  for (std::size_t k = 0; k < 3; ++k) {
    const std::uint32_t e = mesh.triangle_edges[triangle][k];
    const bool up = crossings.vertex_cell[v[k]][axis] < crossings.vertex_cell[v[(k + 1) % 3]][axis];
    for (std::uint32_t c = crossings.edge_begin[e]; c < crossings.edge_begin[e + 1]; ++c) {
      if (crossings.edge_crossings[c].axis != axis) continue;
      const int plane = unpack(crossings.edge_crossings[c].face)[axis];
      PlaneEnds& ends = planes.ends[static_cast<std::size_t>(plane - planes.first)];
      (up ? ends.up : ends.down) = c;
    }
  }
  for (const PlaneEnds& ends : planes.ends)
    if (ends.up == kNone || ends.down == kNone)
      throw InternalFailure("crossings", "triangle " + std::to_string(triangle) +
                                             " does not pass a plane once up and once down");
}

Crossings find_crossings(const Incidence& mesh, const Lattice& lattice, const Oracle& oracle,
                         Lines lines) {
  Crossings out;
  out.vertex_cell.reserve(mesh.positions.size());
  for (const Point& p : mesh.positions) out.vertex_cell.push_back(lattice.cell_of(p));
  cross_edges(mesh, lattice, oracle, out);

  FaceCurves curves(out.edge_crossings.size());
  std::vector<LineStep> steps;
  TrianglePlanes planes;
  out.triangle_begin.reserve(mesh.triangles.size() + 1);
  for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t) {
    out.triangle_begin.push_back(static_cast<std::uint32_t>(out.line_crossings.size()));
    const Triangle& v = mesh.triangles[t];
    if (out.vertex_cell[v[0]] == out.vertex_cell[v[1]] &&
        out.vertex_cell[v[1]] == out.vertex_cell[v[2]])
      continue;
    cross_triangle(mesh, t, lattice, oracle, lines, out, curves, steps, planes);
  }
  out.triangle_begin.push_back(static_cast<std::uint32_t>(out.line_crossings.size()));

  if (lines != Lines::all) return out;
  for (std::uint32_t c = 0; c < out.edge_crossings.size(); ++c)
    if (curves.is_loop(c))
      out.loop_faces[out.edge_crossings[c].axis].push_back(out.edge_crossings[c].face);
  return out;
}

}  // namespace suture::surgery
