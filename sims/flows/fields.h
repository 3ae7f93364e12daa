// Analytic velocity fields u(x, t), each free of divergence by construction.
#pragma once

#include <cstdint>

#include "surgery/tracker.h"

namespace suture::sims {

/// Rigid rotation: rate × axis × (x − centre). Zalesak's is the rate π/314 about (50, 50, ·).
struct RotationParameters {
  Point centre = Point::Zero(), axis = Point::UnitZ();
  double rate = 1;  ///< radians a unit of time
};
/// \throw InvalidInput if the axis has no direction
VelocityField rotation(const RotationParameters& parameters);

enum class EnrightVariant {
  leveque,  ///< g = cos(πt/T), as published
  eltopo    ///< g = sin(2πt/T), which starts and turns at rest
};
/// LeVeque's vortex in the unit cube, reversed so that everything is back in place at T [Enright
/// 2002].
struct EnrightParameters {
  EnrightVariant variant = EnrightVariant::leveque;
  double period = 3;  ///< T
};
VelocityField enright(const EnrightParameters& parameters);

/// Everything moves alike, with this velocity.
VelocityField translation(const Point& velocity);

/// The single vortex in the unit square, the same at every z: ψ = sin²(πx)·sin²(πy)/π [Rudman 1997;
/// LeVeque 1996]. It winds what it moves into a spiral; reversed over 8 it is the usual test.
VelocityField vortex();

/// The field g(t)·u(x, s(t)), g = cos(πt/time) and s = sin(πt/time)·time/π: since s' = g, it is the
/// flow of u for a time of time/π, reached at time/2, and then the same flow backwards.
/// \throw InvalidInput unless time is positive
VelocityField reversed(VelocityField u, double time);

/// The curl of a smooth random vector potential: a sum of plane waves with seeded directions and
/// phases, faded to nothing at `radius` from `centre` so that what is inside stays inside.
struct CurlNoiseParameters {
  std::uint64_t seed = 1;
  int waves = 24;
  double wavelength = 1;  ///< of the longest waves; the shortest are half of it
  double speed = 1;       ///< root mean square, far from where it fades
  double period = 0;      ///< time in which the longest waves pass; 0: a steady field
  Point centre = Point::Zero();
  double radius = 0;  ///< 0: no fading
};
VelocityField curl_noise(const CurlNoiseParameters& parameters);

/// Pulls apart along `axis` and pinches across it: u = rate·(g(s), −g'(s)·r/2), g = w·tanh(s/w), s
/// the distance along the axis and r across it. Beyond the width w the ends move almost rigidly.
struct StretchParameters {
  Point centre = Point::Zero(), axis = Point::UnitX();
  double rate = 1;
  double width = 0;  ///< 0: the linear field rate·(s, −r/2), everywhere
};
VelocityField stretch(const StretchParameters& parameters);

/// Compresses along `axis`, stretches across it, and drives a wave along `up` whose length shrinks
/// with the material, so that a flat sheet across `up` folds up like a curtain.
struct FoldParameters {
  Point centre = Point::Zero(), axis = Point::UnitX(), up = Point::UnitZ();
  double rate = 1;        ///< of the compression, per unit of time
  double amplitude = 1;   ///< speed of the wave, in lengths a unit of time
  double wavelength = 1;  ///< at time 0
};
/// \throw InvalidInput unless axis and up are two directions at right angles
VelocityField fold(const FoldParameters& parameters);

}  // namespace suture::sims
