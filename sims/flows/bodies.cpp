// Bodies that move rigidly, and share their momentum once they have merged.
#include "sims/flows/bodies.h"

#include <Eigen/Geometry>
#include <cmath>

#include "kernel/measure/measures.h"
#include "sims/tracking/vertex_values.h"

namespace suture::sims {
namespace {

class BodiesMotion : public Motion {
 public:
  BodiesMotion(std::vector<Point> velocities, double relaxation)
      : velocities_(std::move(velocities)), relaxation_(relaxation) {}

  std::vector<Point> positions(const Triangles& surface, double dt) override {
    relax(surface, 1 - std::exp(-dt / relaxation_));
    std::vector<Point> moved = surface.positions;
    for (std::size_t v = 0; v < moved.size(); ++v) moved[v] += dt * velocities_[v];
    return moved;
  }

  void surface_changed(const Triangles& surface,
                       const std::vector<std::uint32_t>& vertex_map) override {
    velocities_ = carried(velocities_, Point(Point::Zero()), surface, vertex_map);
  }

 private:
  /// Brings every velocity a part of the way to the mean of its connected component.
  void relax(const Triangles& surface, double part) {
    const Components bodies = components(surface);
    std::vector<Point> momentum(bodies.count, Point::Zero());
    std::vector<double> mass(bodies.count, 0.0);
    std::vector<std::uint32_t> body_of(surface.positions.size(), kNone);
    for (std::size_t t = 0; t < surface.triangles.size(); ++t) {
      const auto& [a, b, c] = surface.triangles[t];
      const auto& x = surface.positions;
      const double area = (x[b] - x[a]).cross(x[c] - x[a]).norm();
      const std::uint32_t body = bodies.of_triangle[t];
      mass[body] += 3 * area;
      for (const std::uint32_t v : {a, b, c}) {
        momentum[body] += area * velocities_[v];
        body_of[v] = body;
      }
    }
    for (std::size_t v = 0; v < velocities_.size(); ++v) {
      const std::uint32_t body = body_of[v];
      if (body == kNone || !(mass[body] > 0)) continue;
      velocities_[v] += part * (momentum[body] / mass[body] - velocities_[v]);
    }
  }

  std::vector<Point> velocities_;
  double relaxation_;
};

}  // namespace

std::unique_ptr<Motion> make_bodies_motion(std::vector<Point> velocities, double relaxation) {
  return std::make_unique<BodiesMotion>(std::move(velocities), relaxation);
}

}  // namespace suture::sims
