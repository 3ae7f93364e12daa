// The exact shape at time 0 carried by the exact flow: a triangulation as fine as its image asks.
#include "sims/study/exact/exact_flow.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <unordered_map>
#include <unordered_set>

#include "kernel/errors.h"
#include "kernel/measure/nearest_triangle.h"

namespace suture::sims {
namespace {

constexpr std::size_t kChecked = 5000;  // triangles whose middles tell the reference's own error

using EdgeKey = std::uint64_t;
EdgeKey key(std::uint32_t a, std::uint32_t b) {
  return static_cast<EdgeKey>(std::min(a, b)) << 32 | std::max(a, b);
}

/// An edge and one of its two triangles.
struct Side {
  EdgeKey edge;
  std::uint32_t triangle;
};

class Refinement {
 public:
  Refinement(const ExactShape& shape, const Carry& carry, const ExactFlowOptions& options)
      : shape_(shape), carry_(carry), options_(options), start_(shape.mesh), face_(shape.face) {
    for (const Point& p : start_.positions) image_.push_back(carry(p));
  }

  ExactSurface all() {
    while (split_marked()) {
      if (start_.triangles.size() > options_.most_triangles)
        throw InvalidInput(fmt::format(
            "a reference within {} takes more than {} triangles; give a larger tolerance",
            options_.tolerance, options_.most_triangles));
    }
    ExactSurface result;
    result.tolerance = options_.tolerance;
    check(result);
    find_features(result);
    result.surface = {std::move(image_), std::move(start_.triangles)};
    return result;
  }

 private:
  const ExactFace& face_of(std::uint32_t triangle) const { return shape_.faces[face_[triangle]]; }

  std::vector<Side> sides() const {
    std::vector<Side> all;
    all.reserve(3 * start_.triangles.size());
    for (std::uint32_t t = 0; t < start_.triangles.size(); ++t)
      for (int i = 0; i < 3; ++i)
        all.push_back({key(start_.triangles[t][i], start_.triangles[t][(i + 1) % 3]), t});
    std::sort(all.begin(), all.end(), [](const Side& a, const Side& b) {
      return a.edge != b.edge ? a.edge < b.edge : a.triangle < b.triangle;
    });
    return all;
  }

  double off_triangle(const Point& p, std::uint32_t triangle) const {
    const Triangle& t = start_.triangles[triangle];
    return distance_to_triangle(p, image_[t[0]], image_[t[1]], image_[t[2]]);
  }

  /// Triangles that no edge told to be too coarse, but whose middle does: their longest edges are
  /// split. A fold can have both its ends and its middle on a chord.
  void look_inside() {
    forced_.clear();
    fine_.resize(start_.triangles.size(), 0);
    for (std::uint32_t t = 0; t < start_.triangles.size(); ++t) {
      if (fine_[t] != 0) continue;
      fine_[t] = 1;
      if (off_triangle(middle_image(t), t) <= 2 * options_.tolerance) continue;
      const Triangle& v = start_.triangles[t];
      std::array<double, 3> length;
      for (int i = 0; i < 3; ++i) length[i] = (image_[v[i]] - image_[v[(i + 1) % 3]]).norm();
      const auto i = std::max_element(length.begin(), length.end()) - length.begin();
      forced_.insert(key(v[i], v[(i + 1) % 3]));
    }
  }

  Point middle_image(std::uint32_t triangle) const {
    const auto& [a, b, c] = start_.triangles[triangle];
    const auto& x = start_.positions;
    return carry_(onto((x[a] + x[b] + x[c]) / 3, face_of(triangle)));
  }

  /// Finds the edges that are too coarse; each gets a vertex. \return whether there was any
  bool mark() {
    middles_.clear();
    look_inside();
    const std::vector<Side> all = sides();
    for (std::size_t i = 0; i + 1 < all.size(); i += 2) {
      const EdgeKey edge = all[i].edge;
      const bool forced = forced_.count(edge) != 0;
      if (!forced && settled_.count(edge) != 0) continue;
      const auto a = static_cast<std::uint32_t>(edge >> 32), b = static_cast<std::uint32_t>(edge);
      const std::uint32_t left = all[i].triangle, right = all[i + 1].triangle;
      const ExactFace &f = face_of(left), &g = face_of(right);
      const Point middle = middle_on(start_.positions[a], start_.positions[b], f, g);
      const Point image = carry_(middle);
      const double off = is_crease(f, g)
                             ? distance_to_triangle(image, image_[a], image_[b], image_[b])
                             : std::min(off_triangle(image, left), off_triangle(image, right));
      if (!forced && off <= options_.tolerance) {
        settled_.insert(edge);
        continue;
      }
      middles_[edge] = static_cast<std::uint32_t>(start_.positions.size());
      start_.positions.push_back(middle);
      image_.push_back(image);
    }
    return !middles_.empty();
  }

  bool split_marked() {
    if (!mark()) return false;
    std::vector<Triangle> finer;
    std::vector<std::uint32_t> faces;
    std::vector<char> fine;
    for (std::size_t t = 0; t < start_.triangles.size(); ++t) {
      split(start_.triangles[t], finer);
      fine.resize(finer.size(), finer.size() == faces.size() + 1 ? fine_[t] : 0);
      faces.resize(finer.size(), face_[t]);
    }
    start_.triangles = std::move(finer);
    face_ = std::move(faces);
    fine_ = std::move(fine);
    return true;
  }

  /// A triangle becomes one to four, by which of its edges have a vertex now.
  void split(Triangle t, std::vector<Triangle>& out) const {
    std::array<std::uint32_t, 3> m{};
    int marked = 0;
    const auto look = [&] {
      marked = 0;
      for (int i = 0; i < 3; ++i) {
        const auto at = middles_.find(key(t[i], t[(i + 1) % 3]));
        m[i] = at == middles_.end() ? kNone : at->second;
        marked += m[i] != kNone;
      }
    };
    look();
    // Turned so that of one edge or two the first is marked and, of two, the last is not.
    while ((marked == 1 && m[0] == kNone) || (marked == 2 && m[2] != kNone)) {
      std::rotate(t.begin(), t.begin() + 1, t.end());
      look();
    }
    if (marked == 0) {
      out.push_back(t);
    } else if (marked == 1) {
      out.insert(out.end(), {{t[0], m[0], t[2]}, {m[0], t[1], t[2]}});
    } else if (marked == 3) {
      out.insert(out.end(), {{t[0], m[0], m[2]}, {t[1], m[1], m[0]}, {t[2], m[2], m[1]}, m});
    } else {
      out.push_back({m[0], t[1], m[1]});
      const bool straight =
          (image_[t[0]] - image_[m[1]]).norm() < (image_[t[2]] - image_[m[0]]).norm();
      if (straight)
        out.insert(out.end(), {{t[0], m[0], m[1]}, {t[0], m[1], t[2]}});
      else
        out.insert(out.end(), {{t[0], m[0], t[2]}, {m[0], m[1], t[2]}});
    }
  }

  void check(ExactSurface& result) const {
    const std::size_t every = std::max<std::size_t>(1, start_.triangles.size() / kChecked);
    double sum = 0, count = 0;
    for (std::uint32_t t = 0; t < start_.triangles.size(); t += static_cast<std::uint32_t>(every)) {
      const double off = off_triangle(middle_image(t), t);
      sum += off;
      count += 1;
      result.max_error = std::max(result.max_error, off);
    }
    result.mean_error = count > 0 ? sum / count : 0;
  }

  void find_features(ExactSurface& result) const {
    const std::vector<Side> all = sides();
    std::map<std::uint32_t, std::vector<std::uint32_t>> faces_at;  // of vertices on creases
    for (std::size_t i = 0; i + 1 < all.size(); i += 2) {
      const ExactFace &f = face_of(all[i].triangle), &g = face_of(all[i + 1].triangle);
      if (!is_crease(f, g)) continue;
      const auto a = static_cast<std::uint32_t>(all[i].edge >> 32),
                 b = static_cast<std::uint32_t>(all[i].edge);
      result.creases.emplace_back(a, b);
      for (const std::uint32_t v : {a, b})
        for (const std::uint32_t t : {all[i].triangle, all[i + 1].triangle}) {
          std::vector<std::uint32_t>& at = faces_at[v];
          if (std::find(at.begin(), at.end(), face_[t]) == at.end()) at.push_back(face_[t]);
        }
    }
    for (const auto& [v, at] : faces_at)
      if (at.size() >= 3) result.corners.push_back(v);
  }

  const ExactShape& shape_;
  const Carry& carry_;
  const ExactFlowOptions& options_;
  Triangles start_;           ///< the vertices at time 0
  std::vector<Point> image_;  ///< and at the time asked for
  std::vector<std::uint32_t> face_;
  std::unordered_map<EdgeKey, std::uint32_t> middles_;  ///< the new vertex of a marked edge
  std::unordered_set<EdgeKey> settled_, forced_;        ///< edges fine enough; to be split anyway
  std::vector<char> fine_;  ///< of each triangle, whether its middle was looked at
};

}  // namespace

ExactSurface exact_flow(const ExactShape& shape, const Carry& carry,
                        const ExactFlowOptions& options) {
  if (!(options.tolerance > 0))
    throw InvalidInput("the tolerance of an exact reference is a length above zero");
  return Refinement(shape, carry, options).all();
}

}  // namespace suture::sims
