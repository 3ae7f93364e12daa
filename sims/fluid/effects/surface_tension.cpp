// Surface tension: the pressure jump that curvature makes at the faces of the physics grid that the
// surface crosses, and what the surface does of itself.
#include "sims/fluid/effects/surface_tension.h"

#include <cmath>
#include <numbers>

#include "kernel/errors.h"
#include "sims/fluid/effects/tension/surface_velocity.h"
#include "sims/fluid/liquid/crossing.h"

namespace suture::sims {

std::array<std::vector<double>, 3> tension_jump(const Triangles& surface,
                                                const NearestTriangle& nearest,
                                                const std::vector<double>& curvature,
                                                const Liquid& liquid, double tension) {
  std::array<std::vector<double>, 3> jump;
  for (std::vector<double>& along : jump) along.assign(liquid.grid->size(), 0);
  for_each_crossing(liquid, [&](int axis, Slot face, Slot, const Point& at) {
    const SurfacePlace place = nearest_place(surface, nearest, at);
    for (int k = 0; k < 3; ++k)
      jump[axis][face] += tension * place.weights[k] * curvature[place.corners[k]];
  });
  return jump;
}

double capillary_step(double h, double density, double tension) {
  if (!(h > 0) || !std::isfinite(h) || !(density > 0) || !std::isfinite(density) ||
      !(tension >= 0) || !std::isfinite(tension))
    throw InvalidInput(
        "a capillary wave needs a finite positive cell size and density, and a tension that is not "
        "negative; they are " +
        number(h) + ", " + number(density) + " and " + number(tension));
  return h * std::sqrt(density * h / (4 * std::numbers::pi * tension));
}

double stable_share(double dt, double h, double density, double tension) {
  if (!(dt > 0)) throw InvalidInput("surface tension: a step must be above 0 long");
  const double part = capillary_step(h, density, tension) / dt;
  return part < 1 ? part * part : 1;
}

std::vector<Point> ripple_velocity(const Triangles& surface, double h, double density,
                                   double tension, CurvatureOptions options) {
  options.smoothing /= 2;
  std::vector<Point> velocity = ripples(surface, h, options);
  const double rate = kRippleRate / capillary_step(h, density, tension);
  for (Point& v : velocity) v *= rate;
  return velocity;
}

}  // namespace suture::sims
