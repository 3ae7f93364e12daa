// Lattice paths are integer walks: columns located by the oracle decide each step [§5, §6.1].
#include "surgery/detect/lattice_path.h"

#include <algorithm>
#include <optional>

#include "kernel/errors.h"

namespace suture::surgery {

namespace {

/// Indices of cells on one axis, both ends included.
struct Range {
  int low, high;
};

/// The largest j of the range that is not above, given that `low` is not and that all past the
/// first above are. Gallops from a guess, so a good one costs two questions and a bad one few.
template <class Above>
int locate(Range range, int guess, Above above) {
  auto [low, high] = range;
  const int j = std::clamp(guess, low, high);
  const bool down = j > low && above(j);
  (down ? high : low) = down ? j - 1 : j;
  for (int stride = 1; low < high; stride *= 2) {
    const int probe = down ? std::max(high - stride + 1, low + 1) : std::min(low + stride, high);
    const bool is_above = above(probe);
    (is_above ? high : low) = is_above ? probe - 1 : probe;
    if (is_above != down) break;
  }
  while (low < high) {
    const int middle = low + (high - low + 1) / 2;
    if (above(middle))
      high = middle - 1;
    else
      low = middle;
  }
  return low;
}

/// The columns in which a mesh edge passes the planes of the lattice.
struct EdgeColumns {
  const LatticeSegment& s;
  const ShiftedLattice& on;

  /// The column on `axis` where the segment passes plane i across `across`.
  int at(int across, int i, int axis) const {
    const int low = std::min(s.p_cell[axis], s.q_cell[axis]);
    const int high = std::max(s.p_cell[axis], s.q_cell[axis]);
    if (low == high) return low;
    const double plane = on.lattice.plane(across, i);
    const double t = (plane - s.p[across]) / (s.q[across] - s.p[across]);
    const int guess = on.lattice.cell_of(axis, s.p[axis] + t * (s.q[axis] - s.p[axis]));
    const int upward = s.p_cell[across] < s.q_cell[across] ? 1 : -1;
    return locate({low, high}, guess, [&](int j) {
      return upward *
                 on.oracle.edge_side(s.p, s.q, {across, axis, plane, on.lattice.plane(axis, j)}) >
             0;
    });
  }
};

/// The cells in which a triangle passes the lattice lines that its chord passes.
struct ChordPositions {
  const PlaneChord& chord;
  const ShiftedLattice& on;

  /// The cell along `axis` where the triangle passes the lattice line through `node`; `normal` is
  /// the sign of its normal there.
  int at(int axis, Index3 node, int normal) const {
    const int low = std::min(chord.from[axis], chord.to[axis]);
    const int high = std::max(chord.from[axis], chord.to[axis]);
    if (low == high) return low;
    const LatticeTriangle& t = chord.triangle;
    Point at = on.lattice.node({node[0], node[1], node[2]});
    at[axis] = t.a[axis];
    const double x = t.a[axis] - t.normal.dot(at - t.a) / t.normal[axis];
    return locate({low, high}, on.lattice.cell_of(axis, x), [&](int k) {
      node[axis] = k;
      return normal * on.oracle.triangle_side(t.a, t.b, t.c, on.lattice.node(node)) > 0;
    });
  }
};

}  // namespace

void edge_path(const LatticeSegment& s, const ShiftedLattice& on, std::vector<FaceStep>& path) {
  const EdgeColumns columns{s, on};
  Index3 cell = s.p_cell;
  std::array<std::optional<Index3>, 3>
      next;  // the face through which the segment leaves on each axis
  while (cell != s.q_cell) {
    int taken = -1;
    for (int a = 0; a < 3 && taken < 0; ++a) {
      if (cell[a] == s.q_cell[a]) continue;
      const int up = s.q_cell[a] > cell[a] ? 1 : 0;
      const int b = next_axis(a), c = prev_axis(a);
      if (!next[a]) {
        Index3 face;
        face[a] = cell[a] + up;
        face[b] = columns.at(a, face[a], b);
        face[c] = columns.at(a, face[a], c);
        next[a] = face;
      }
      if ((*next[a])[b] == cell[b] && (*next[a])[c] == cell[c]) taken = a;
    }
    if (taken < 0) throw InternalFailure("crossings", "a mesh edge has no lattice path");
    path.push_back({pack(*next[taken]), taken});
    cell[taken] += s.q_cell[taken] > cell[taken] ? 1 : -1;
    next[taken].reset();
  }
}

LatticeTriangle lattice_triangle(const Point& a, const Point& b, const Point& c) {
  return {a, b, c, (b - a).cross(c - a)};
}

void plane_path(const PlaneChord& chord, const ShiftedLattice& on, std::vector<LineStep>& path) {
  // Seen along cyclic axes (a, b, c), the part above the plane lies left of the way down → up; so a
  // step along ±b passes a line along c with N_c = ±, and a step along ±c one along b with N_b = ∓.
  const ChordPositions positions{chord, on};
  const std::array<int, 2> axes = {next_axis(chord.axis), prev_axis(chord.axis)};
  const Index3 to = chord.to;
  Index3 face = chord.from;
  std::array<std::optional<int>, 2> other;  // where the next step on either axis passes its line
  while (face != to) {
    int taken = -1;
    for (int s = 0; s < 2 && taken < 0; ++s) {
      const int along = axes[s], line = axes[1 - s];
      if (face[along] == to[along]) continue;
      const int direction = to[along] > face[along] ? 1 : -1;
      if (!other[s]) {
        Index3 node = face;
        node[along] += direction > 0 ? 1 : 0;
        other[s] = positions.at(line, node, s == 0 ? direction : -direction);
      }
      if (*other[s] != face[line]) continue;
      taken = s;
      Index3 edge = face;
      edge[along] += direction > 0 ? 1 : 0;
      path.push_back({pack(edge), line, s == 0 ? direction : -direction});
      face[along] += direction;
      other[s].reset();
    }
    if (taken < 0) throw InternalFailure("crossings", "triangle ∩ plane has no lattice path");
  }
}

}  // namespace suture::surgery
