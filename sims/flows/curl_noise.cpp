// Curl noise: the analytic curl of a seeded sum of plane waves [Bridson et al. 2007].
#include <Eigen/Geometry>
#include <cmath>
#include <memory>
#include <numbers>

#include "kernel/random.h"
#include "sims/flows/fields.h"

namespace suture::sims {
namespace {

/// One term of the vector potential: amplitude · cos(k·x + phase + frequency·t).
struct Wave {
  Point k, amplitude;
  double phase, frequency;
};

Point random_direction(Random& random) {
  const double z = random.uniform(-1, 1), a = random.uniform(0, 2 * std::numbers::pi);
  const double r = std::sqrt(1 - z * z);
  return {r * std::cos(a), r * std::sin(a), z};
}

std::vector<Wave> make_waves(const CurlNoiseParameters& parameters) {
  Random random(parameters.seed);
  std::vector<Wave> waves;
  double square = 0;  // mean square of the curl: half the sum of |k × amplitude|²
  for (int i = 0; i < parameters.waves; ++i) {
    const double octave = random.uniform(0, 1);
    const double k = 2 * std::numbers::pi / parameters.wavelength * std::exp2(octave);
    Wave wave;
    wave.k = k * random_direction(random);
    wave.amplitude = random_direction(random) / (k * std::exp2(octave));
    wave.phase = random.uniform(0, 2 * std::numbers::pi);
    wave.frequency = parameters.period > 0
                         ? 2 * std::numbers::pi / parameters.period * std::exp2(octave) *
                               (random.next() % 2 == 0 ? 1 : -1)
                         : 0;
    square += wave.k.cross(wave.amplitude).squaredNorm() / 2;
    waves.push_back(wave);
  }
  for (Wave& wave : waves) wave.amplitude *= parameters.speed / std::sqrt(square);
  return waves;
}

}  // namespace

VelocityField curl_noise(const CurlNoiseParameters& parameters) {
  const auto waves = std::make_shared<const std::vector<Wave>>(make_waves(parameters));
  const Point centre = parameters.centre;
  const double radius = parameters.radius;
  return [=](const Point& x, double t) -> Point {
    Point curl = Point::Zero(), potential = Point::Zero();
    for (const Wave& wave : *waves) {
      const double angle = wave.k.dot(x) + wave.phase + wave.frequency * t;
      curl -= std::sin(angle) * wave.k.cross(wave.amplitude);
      potential += std::cos(angle) * wave.amplitude;
    }
    if (radius <= 0) return curl;
    // The potential times f = (1 − |x−c|²/R²)²: both f and its gradient vanish at R.
    const Point d = (x - centre) / radius;
    const double rest = 1 - d.squaredNorm();
    if (rest <= 0) return Point::Zero();
    const Point gradient = -4 * rest / radius * d;
    return rest * rest * curl + gradient.cross(potential);
  };
}

}  // namespace suture::sims
