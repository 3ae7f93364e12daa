// Lines are cut by the body's own triangles only; the surfaces are asked at points of what is left.
#include "kernel/measure/body_loss.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <optional>

#include "kernel/measure/line_cuts.h"
#include "kernel/measure/measures.h"
#include "kernel/measure/signed_distance.h"

namespace suture {
namespace {

/// The triangles of each component, with the vertices that they use.
std::vector<Triangles> bodies_of(const Triangles& surface, const Components& parts) {
  std::vector<Triangles> bodies(parts.count);
  std::vector<std::uint32_t> number(surface.positions.size(), kNone);
  for (std::size_t t = 0; t < surface.triangles.size(); ++t) {
    Triangles& body = bodies[parts.of_triangle[t]];
    Triangle own;
    for (std::size_t k = 0; k < 3; ++k) {
      const std::uint32_t v = surface.triangles[t][k];  // in one component only
      if (number[v] == kNone) {
        number[v] = static_cast<std::uint32_t>(body.positions.size());
        body.positions.push_back(surface.positions[v]);
      }
      own[k] = number[v];
    }
    body.triangles.push_back(own);
  }
  return bodies;
}

/// The axis along which the body's triangles are seen largest.
int widest_axis(const Triangles& body) {
  Point seen = Point::Zero();
  for (const auto& [a, b, c] : body.triangles) {
    const auto& x = body.positions;
    seen += (x[b] - x[a]).cross(x[c] - x[a]).cwiseAbs();
  }
  int axis = 0;
  seen.maxCoeff(&axis);
  return axis;
}

constexpr int kParts = 4;  // points on each stretch of a line

/// The lines to the longer side of each body, so that all bodies together take some 50,000 points.
double lines_for(const BodyChoice& choice) {
  constexpr double kPoints = 50000, kLeast = 4;
  const double share = kPoints / kParts / static_cast<double>(choice.which.size());
  return std::clamp(std::floor(std::sqrt(share)), kLeast,
                    std::max(kLeast, static_cast<double>(choice.most_lines)));
}

/// A grid across the body, or nothing where it has no width.
std::optional<LineGrid> grid_across(const Triangles& body, const Box& box, double lines) {
  const int axis = widest_axis(body);
  const Point size = box.high - box.low;
  const double spacing = std::max(size[(axis + 1) % 3], size[(axis + 2) % 3]) / lines;
  if (!(spacing > 0) || !std::isfinite(spacing)) return std::nullopt;
  return grid_along(axis, box, spacing);
}

/// Points on lines through the body, each for a stretch of the same line.
struct Samples {
  std::vector<Point> points;
  std::vector<double> lengths;
};

/// The middles of four parts of each stretch on which the body's winding has the sign of `side`.
Samples samples_in(const Triangles& body, const LineGrid& grid, int side) {
  std::vector<LineCut> cuts;
  for (const Triangle& t : body.triangles) Cutter{body, grid, 0}.cut(t, cuts);
  sort_along(cuts);
  Samples samples;
  int winding = 0;
  for (std::size_t i = 0; i + 1 < cuts.size(); ++i) {
    const LineCut &from = cuts[i], &to = cuts[i + 1];
    winding = i > 0 && cuts[i - 1].line != from.line ? from.step : winding + from.step;
    if (to.line != from.line || winding * side < 1) continue;
    Point p;
    p[grid.across1] = grid.first(from.line / grid.count2);
    p[grid.across2] = grid.second(from.line % grid.count2);
    for (int k = 0; k < kParts; ++k) {
      p[grid.along] = from.height + (k + 0.5) / kParts * (to.height - from.height);
      samples.points.push_back(p);
      samples.lengths.push_back((to.height - from.height) / kParts);
    }
  }
  return samples;
}

/// A surface that may be empty, ready to be asked whether a point is inside.
class Inside {
 public:
  explicit Inside(const Triangles& surface) {
    if (!surface.triangles.empty()) windings_.emplace(surface);
  }
  bool operator()(const Point& p) const { return windings_ && windings_->winding(p) >= 1; }

 private:
  std::optional<SignedDistance> windings_;
};

}  // namespace

std::vector<BodyLoss> body_losses(const Triangles& before, const Triangles& after,
                                  const BodyChoice& choice) {
  if (choice.which.empty()) return {};
  const double lines = lines_for(choice);
  const std::vector<Triangles> bodies = bodies_of(before, components(before));
  const Inside was(before), is(after);
  std::vector<BodyLoss> losses;
  for (const std::uint32_t c : choice.which) {
    const Box box = bounding_box(bodies[c].positions);
    BodyLoss& loss =
        losses.emplace_back(BodyLoss{c, volume(bodies[c]), 0, Point(box.low / 2 + box.high / 2)});
    const std::optional<LineGrid> grid = grid_across(bodies[c], box, lines);
    if (!grid) continue;
    const bool solid = loss.volume >= 0;
    const Samples samples = samples_in(bodies[c], *grid, solid ? 1 : -1);
    double lost = 0, all = 0;
    for (std::size_t i = 0; i < samples.points.size(); ++i) {
      all += samples.lengths[i];
      if (is(samples.points[i]) != solid && was(samples.points[i]) == solid)
        lost += samples.lengths[i];
    }
    loss.part = all > 0 ? lost / all : 0;
  }
  return losses;
}

std::vector<BodyLoss> body_losses(const Triangles& before, const Triangles& after) {
  std::vector<std::uint32_t> all(components(before).count);
  std::iota(all.begin(), all.end(), 0U);
  return body_losses(before, after, {std::move(all)});
}

}  // namespace suture
