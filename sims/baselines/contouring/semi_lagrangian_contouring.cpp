// Semi-Lagrangian contouring: each step a new mesh, where the old mesh's distance is zero upstream.
#include "sims/baselines/contouring/semi_lagrangian_contouring.h"

#include <cmath>
#include <optional>
#include <string>

#include "kernel/errors.h"
#include "kernel/measure/signed_distance.h"
#include "sims/baselines/grid/level_set_grid.h"
#include "sims/baselines/grid/paths.h"
#include "sims/support/clock.h"

namespace suture::sims {
namespace {

/// The new surface's implicit function in one step, in cells.
struct Upstream {
  const SignedDistance& old;
  GridVelocity u;  ///< in the scene's unit
  PathStep step;
  double cell_size;

  double operator()(const Point& p) const {
    const Point source = path_end(u, p, step.back());
    require_finite(source);
    return old.at(source) / cell_size;
  }
  Point downstream(const Point& p) const {
    const Point end = path_end(u, p, step);
    require_finite(end);
    return end;
  }
  static void require_finite(const Point& p) {
    if (!p.allFinite())
      throw InvalidInput(
          "a path within one step leads out of the finite numbers; check the velocity field");
  }
};

/// A bracketed zero of f between 0 and 1, f(0) and f(1) given: regula falsi, where an end that
/// stays twice counts half [Dowell and Jarratt 1971].
double bracketed_zero(const auto& f, double f0, double f1, int evaluations) {
  constexpr double kNear = 1e-9;  // of a cell
  double low = 0, high = 1, t = f0 / (f0 - f1);
  int stayed = 0;
  for (int k = 0; k < evaluations; ++k) {
    const double value = f(t);
    if (std::abs(value) < kNear) break;
    if ((value < 0) == (f0 < 0)) {
      low = t;
      f0 = value;
      if (stayed == 1) f1 /= 2;
      stayed = 1;
    } else {
      high = t;
      f1 = value;
      if (stayed == -1) f0 /= 2;
      stayed = -1;
    }
    t = low + (high - low) * (f0 / (f0 - f1));
  }
  return t;
}

class Contouring : public SurfaceTracker {
 public:
  Contouring(const Triangles& surface, const ContouringOptions& o)
      : options_(o), band_{o.cell_size, o.origin, kMargin}, surface_(surface) {
    require_valid(band_);
    if (o.trace_order < 2 || o.trace_order > 4)
      throw InvalidInput("semi-Lagrangian contouring's trace_order is " +
                         std::to_string(o.trace_order) + "; it must be 2 to 4");
    if (o.refinements < 0 || o.refinements > 100)
      throw InvalidInput("semi-Lagrangian contouring's refinements are " +
                         std::to_string(o.refinements) + "; they must be 0 to 100");
  }

  void advect(const VelocityField& u, double dt) override {
    if (!surface_.triangles.empty()) step(u, dt);
    time_ += dt;
  }

  void end_of_frame() override {}
  const Triangles& surface() override { return surface_; }

  double distance(const Point& p) override {
    if (!distance_) distance_.emplace(surface_);
    return distance_->at(p);
  }

  double time() const override { return time_; }

  TrackerCost cost() const override {
    return {costs_.seconds,
            {{"nodes", nodes_}, {"refinements", refined_}, {"bands_widened", widened_}}};
  }

 private:
  static constexpr double kMargin = 2;   ///< cells to the surface as its vertices are carried
  static constexpr double kWidest = 64;  ///< cells

  void step(const VelocityField& u, double dt) {
    Lap lap;
    if (!distance_) distance_.emplace(surface_);
    const Upstream upstream{
        *distance_, {u, Point::Zero(), 1}, {time_, dt, options_.trace_order}, options_.cell_size};
    Triangles carried = surface_;
    for (Point& p : carried.positions) p = upstream.downstream(p);
    const openvdb::DoubleGrid::Ptr grid = band_round(carried, upstream);
    nodes_ += static_cast<double>(grid->activeVoxelCount());
    costs_.add_seconds("distances", lap.next());
    surface_ = contour(*grid, [&](const CubeCorner& from, const CubeCorner& to) {
      return vertex(upstream, from, to);
    });
    distance_.reset();
    costs_.add_seconds("contour", lap.next());
  }

  /// The vertices say where the new surface is but for what happens between them: if that is more
  /// than the band, the band grows.
  openvdb::DoubleGrid::Ptr band_round(const Triangles& carried, const Upstream& upstream) {
    BandOptions band = band_;
    for (; band.half_width <= kWidest; band.half_width *= 2) {
      openvdb::DoubleGrid::Ptr grid = make_band(carried, band, upstream);
      if (holds_zero_set(*grid)) return grid;
      ++widened_;
    }
    throw InvalidInput("in one step the velocity carries the surface's triangles more than " +
                       std::to_string(static_cast<int>(kWidest)) +
                       " cells from where it carries their vertices; take shorter steps");
  }

  Point vertex(const Upstream& upstream, const CubeCorner& from, const CubeCorner& to) {
    constexpr double kOffEnds = 1e-6;  // of an edge: vertices of different edges stay apart
    const Point p = band_.place(openvdb::Coord(from.node[0], from.node[1], from.node[2]));
    const Point q = band_.place(openvdb::Coord(to.node[0], to.node[1], to.node[2]));
    const auto along = [&](double t) {
      ++refined_;
      return upstream(p + t * (q - p));
    };
    const double zero = bracketed_zero(along, from.value, to.value, options_.refinements);
    return p + std::clamp(zero, kOffEnds, 1 - kOffEnds) * (q - p);
  }

  ContouringOptions options_;
  BandOptions band_;
  Triangles surface_;
  std::optional<SignedDistance> distance_;  ///< of the surface as it is, once it was asked for
  double time_ = 0;
  Costs costs_{{{"distances", 0}, {"contour", 0}}, {}};
  double nodes_ = 0, refined_ = 0, widened_ = 0;
};

}  // namespace

std::unique_ptr<SurfaceTracker> make_semi_lagrangian_contouring(const Triangles& surface,
                                                                const ContouringOptions& options) {
  return std::make_unique<Contouring>(surface, options);
}

}  // namespace suture::sims
