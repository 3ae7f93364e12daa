// Directed sides from the paths along mesh edges and in planes, linked to one cycle a cell [§6.1].
#include "surgery/operate/triangle_pieces.h"

#include <algorithm>
#include <string>

#include "kernel/errors.h"

namespace suture::surgery {

namespace {

struct PlanePath {
  int axis;
  std::uint32_t up, down;  // local sites
  LatticeId from;          // face at `up`
  std::size_t begin, end;  // its steps
};

class Walk {
 public:
  Walk(const CrossedMesh& in, std::uint32_t triangle)
      : in_(in), mesh_(in.mesh), crossings_(in.crossings), triangle_(triangle) {
    out_.triangle = triangle;
  }

  TrianglePieces pieces() {
    out_.sides.reserve(32);
    walk_edges();
    walk_planes();
    collect_lines();
    for (const PlanePath& path : paths_) emit(path);
    link();
    return std::move(out_);
  }

 private:
  [[noreturn]] void fail(const char* what) const {
    throw InternalFailure("cut", "triangle " + std::to_string(triangle_) + ": " + what);
  }

  std::uint32_t local(std::uint32_t crossing) const {
    for (std::size_t k = 0; k < 3; ++k) {
      const std::uint32_t e = mesh_.triangle_edges[triangle_][k];
      const std::uint32_t begin = crossings_.edge_begin[e], end = crossings_.edge_begin[e + 1];
      if (crossing < begin || crossing >= end) continue;
      const bool forward = mesh_.edges[e][0] == mesh_.triangles[triangle_][k];
      return first_site_[k] + (forward ? crossing - begin : end - 1 - crossing);
    }
    fail("a plane path starts at a crossing that is not on it");
  }

  void walk_edges() {
    const Triangle& v = mesh_.triangles[triangle_];
    for (int k = 0; k < 3; ++k) {
      const std::uint32_t e = mesh_.triangle_edges[triangle_][k];
      const std::uint32_t begin = crossings_.edge_begin[e], end = crossings_.edge_begin[e + 1];
      const bool forward = mesh_.edges[e][0] == v[k];
      LatticeId cell = pack(crossings_.vertex_cell[v[k]]);
      std::uint32_t from = static_cast<std::uint32_t>(k);
      first_site_[k] = static_cast<std::uint32_t>(3 + out_.edge_sites.size());
      for (std::uint32_t i = 0; i < end - begin; ++i) {
        const std::uint32_t crossing = forward ? begin + i : end - 1 - i;
        const FaceStep& face = crossings_.edge_crossings[crossing];
        const auto to = static_cast<std::uint32_t>(3 + out_.edge_sites.size());
        out_.edge_sites.push_back({crossing, k});
        out_.sides.push_back({cell, kNoCell, from, to, k});
        cell = cell == face.face ? step(face.face, face.axis, -1) : face.face;
        from = to;
      }
      out_.sides.push_back({cell, kNoCell, from, static_cast<std::uint32_t>((k + 1) % 3), k});
    }
  }

  void walk_planes() {
    const Triangle& v = mesh_.triangles[triangle_];
    const LatticeTriangle shape =
        lattice_triangle(mesh_.positions[v[0]], mesh_.positions[v[1]], mesh_.positions[v[2]]);
    TrianglePlanes planes;
    for (int axis = 0; axis < 3; ++axis) {
      planes.find(in_, triangle_, axis);
      for (const PlaneEnds& ends : planes.ends) {
        const LatticeId from = crossings_.edge_crossings[ends.up].face;
        const LatticeId to = crossings_.edge_crossings[ends.down].face;
        const std::size_t begin = steps_.size();
        plane_path({shape, axis, unpack(from), unpack(to)}, in_.on, steps_);
        paths_.push_back({axis, local(ends.up), local(ends.down), from, begin, steps_.size()});
      }
    }
  }

  static bool before(const TrianglePieces::LineSite& a, const TrianglePieces::LineSite& b) {
    return a.axis != b.axis ? a.axis < b.axis : a.edge < b.edge;
  }

  /// Each line is met in exactly two planes; the cyclic one names it.
  void collect_lines() {
    for (const PlanePath& path : paths_)
      for (std::size_t i = path.begin; i < path.end; ++i)
        if (steps_[i].axis == prev_axis(path.axis))
          out_.line_sites.push_back({steps_[i].axis, steps_[i].edge});
    std::sort(out_.line_sites.begin(), out_.line_sites.end(), before);
  }

  std::uint32_t local(const LineStep& s) const {
    const TrianglePieces::LineSite wanted{s.axis, s.edge};
    const auto at =
        std::lower_bound(out_.line_sites.begin(), out_.line_sites.end(), wanted, before);
    if (at == out_.line_sites.end() || at->axis != s.axis || at->edge != s.edge)
      fail("a lattice line is met in one plane only");
    return static_cast<std::uint32_t>(3 + out_.edge_sites.size()) +
           static_cast<std::uint32_t>(at - out_.line_sites.begin());
  }

  void emit(const PlanePath& path) {
    Index3 face = unpack(path.from);
    std::uint32_t from = path.up;
    auto both = [&](std::uint32_t to) {  // the lower cell has the chord from up to down
      const LatticeId upper = pack(face), lower = step(upper, path.axis, -1);
      out_.sides.push_back({lower, upper, from, to});
      out_.sides.push_back({upper, lower, to, from});
      from = to;
    };
    for (std::size_t i = path.begin; i < path.end; ++i) {
      const LineStep& s = steps_[i];
      both(local(s));
      const int along = 3 - path.axis - s.axis;
      face[along] = unpack(s.edge)[along] == face[along] ? face[along] - 1 : face[along] + 1;
    }
    both(path.down);
  }

  void link() {
    auto& sides = out_.sides;
    std::stable_sort(sides.begin(), sides.end(),
                     [](const PieceSide& a, const PieceSide& b) { return a.cell < b.cell; });
    const auto n = static_cast<std::uint32_t>(sides.size());
    for (std::uint32_t begin = 0, end = 0; begin < n; begin = end) {
      while (end < n && sides[end].cell == sides[begin].cell) ++end;
      if (end - begin < 3) fail("a piece has fewer than three sides");
      for (std::uint32_t i = begin; i < end; ++i)
        for (std::uint32_t j = begin; j < end; ++j)
          if (sides[j].from == sides[i].to) sides[i].next = j;
      std::uint32_t at = begin, length = 0;
      do {
        at = sides[at].next;
        ++length;
      } while (at != kNone && at != begin && length <= end - begin);
      if (at != begin || length != end - begin) fail("the sides of a piece are not one cycle");
    }
    for (std::uint32_t i = 0; i < n; ++i)
      if (sides[i].neighbour != kNoCell) sides[i].twin = find_twin(sides[i]);
  }

  std::uint32_t find_twin(const PieceSide& side) const {
    const auto& sides = out_.sides;
    auto at = std::lower_bound(sides.begin(), sides.end(), side.neighbour,
                               [](const PieceSide& s, LatticeId cell) { return s.cell < cell; });
    for (; at != sides.end() && at->cell == side.neighbour; ++at)
      if (at->from == side.to && at->to == side.from && at->neighbour == side.cell)
        return static_cast<std::uint32_t>(at - sides.begin());
    fail("a side has no twin in the neighbouring cell");
  }

  const CrossedMesh& in_;
  const Incidence& mesh_;
  const Crossings& crossings_;
  std::uint32_t triangle_;
  TrianglePieces out_;
  std::array<std::uint32_t, 3> first_site_{};  // of each edge; its crossings follow in order
  std::vector<PlanePath> paths_;
  std::vector<LineStep> steps_;  // of all paths
};

}  // namespace

TrianglePieces triangle_pieces(const CrossedMesh& in, std::uint32_t triangle) {
  return Walk(in, triangle).pieces();
}

}  // namespace suture::surgery
