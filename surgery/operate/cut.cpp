// Each touched triangle keeps its pieces outside the region, merged where that is safe [§6.1].
#include "surgery/operate/cut.h"

#include <algorithm>
#include <map>
#include <optional>

#include "surgery/operate/kept_pieces.h"

namespace suture::surgery {

namespace {

enum class Touch { outside, partly, inside };

/// Whether the triangle's cells are all outside the region, all in it, or both.
Touch touch(const Detected& in, const std::vector<char>& vertex_in, std::uint32_t t) {
  const Triangle& v = in.mesh.triangles[t];
  const auto& at = in.crossings.vertex_cell;
  if (at[v[0]] == at[v[1]] && at[v[1]] == at[v[2]])
    return vertex_in[v[0]] != 0 ? Touch::inside : Touch::outside;  // most triangles of a fine mesh
  bool some = false, all = true;
  for_each_cell(in.crossed(), t, [&](LatticeId cell) {
    const bool held = in.region.holds(cell);
    some |= held;
    all &= held;
  });
  return !some ? Touch::outside : all ? Touch::inside : Touch::partly;
}

/// Cuts triangles until no one's demand for more vertices on an edge is left unheard by its
/// neighbour.
class Cutter {
 public:
  Cutter(const CutOptions& options, Sites& sites)
      : in_(sites.detected()),
        options_(options),
        sites_(sites),
        inserted_(in_.crossings.edge_crossings.size(), 0) {
    std::vector<char> vertex_in;  // whether each vertex is in the region
    vertex_in.reserve(in_.crossings.vertex_cell.size());
    for (const Index3& cell : in_.crossings.vertex_cell)
      vertex_in.push_back(in_.region.holds(pack(cell)) ? 1 : 0);
    for (std::uint32_t t = 0; t < in_.mesh.triangles.size(); ++t) {
      const Touch how = touch(in_, vertex_in, t);
      if (how == Touch::inside) inside_.push_back(t);
      if (how == Touch::partly) waiting_.push_back(t);
      if (how == Touch::partly && options.pieces == Pieces::cell_by_cell)
        split_.insert_or_assign(t, 1);
    }
    for (const auto& [t, unused] : split_) insert_all(t);
  }

  CutMesh cut_mesh() {
    for (std::size_t next = 0; next < waiting_.size(); ++next) cut_triangle(waiting_[next]);
    CutMesh result;
    for (const std::uint32_t t : inside_)
      if (!done_.contains(t)) result.whole.push_back(t);  // else a split neighbour had it cut too
    result.touched = result.whole;
    for (const auto& [t, kept] : done_) {
      result.touched.push_back(t);
      result.dropped.insert(result.dropped.end(), kept.dropped.begin(), kept.dropped.end());
      result.kept.insert(result.kept.end(), kept.triangles.begin(), kept.triangles.end());
      result.boundary.insert(result.boundary.end(), kept.arcs.begin(), kept.arcs.end());
    }
    std::sort(result.touched.begin(), result.touched.end());
    result.split_triangles = split_.size();
    return result;
  }

 private:
  struct Kept {
    std::vector<Triangle> triangles, dropped;
    std::vector<Arc> arcs;
  };

  void cut_triangle(std::uint32_t t) {
    const TrianglePieces pieces = triangle_pieces(in_.crossed(), t);
    KeptPieces kept(pieces, sites_, Part::outside);
    std::optional<KeptPieces> dropped;
    if (options_.inside == Inside::made) dropped.emplace(pieces, sites_, Part::inside);
    if (!split_.contains(t)) {
      if (auto merged = merge(kept, dropped)) {
        done_[t] = std::move(*merged);
        return;
      }
      split_.emplace(t, 1);
      insert_all(t);
    }
    done_[t] = {kept.cell_by_cell(), dropped ? dropped->cell_by_cell() : std::vector<Triangle>{},
                kept.arcs()};
  }

  /// Both parts merged, or nothing where one of them cannot be.
  std::optional<Kept> merge(KeptPieces& kept, std::optional<KeptPieces>& dropped) const {
    auto outside = kept.merged(inserted_);
    if (!outside) return std::nullopt;
    if (!dropped) return Kept{std::move(*outside), {}, kept.arcs()};
    dropped->avoid(*outside);
    auto inside = dropped->merged(inserted_);
    if (!inside) return std::nullopt;
    return Kept{std::move(*outside), std::move(*inside), kept.arcs()};
  }

  /// Every crossing of the triangle's edges becomes a vertex, so its neighbours must be cut again.
  void insert_all(std::uint32_t t) {
    for (const std::uint32_t e : in_.mesh.triangle_edges[t]) {
      bool fresh = false;
      for (std::uint32_t c = in_.crossings.edge_begin[e]; c < in_.crossings.edge_begin[e + 1];
           ++c) {
        fresh |= inserted_[c] == 0;
        inserted_[c] = 1;
      }
      const auto& [a, b] = in_.mesh.edge_triangles[e];
      const std::uint32_t neighbour = a == t ? b : a;
      if (fresh && !split_.contains(neighbour)) waiting_.push_back(neighbour);
    }
  }

  const Detected& in_;
  CutOptions options_;
  Sites& sites_;
  std::vector<char> inserted_;  // by edge crossing: a vertex although no region boundary is there
  std::vector<std::uint32_t> inside_, waiting_;
  std::map<std::uint32_t, Kept> done_;
  std::map<std::uint32_t, char> split_;
};

}  // namespace

CutMesh cut(const CutOptions& options, Sites& sites) { return Cutter(options, sites).cut_mesh(); }

}  // namespace suture::surgery
