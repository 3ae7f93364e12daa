// The classic Runge–Kutta method of order 4, vertex by vertex [§4].
#include "surgery/advect.h"

namespace suture::surgery {

std::vector<Point> advected(const std::vector<Point>& positions, const VelocityField& u,
                            const TimeStep& step) {
  const auto [t, dt] = step;
  std::vector<Point> moved;
  moved.reserve(positions.size());
  for (const Point& x : positions) {
    const Point k1 = u(x, t);
    const Point k2 = u(x + dt / 2 * k1, t + dt / 2);
    const Point k3 = u(x + dt / 2 * k2, t + dt / 2);
    const Point k4 = u(x + dt * k3, t + dt);
    moved.push_back(x + dt / 6 * (k1 + 2 * k2 + 2 * k3 + k4));
  }
  return moved;
}

}  // namespace suture::surgery
