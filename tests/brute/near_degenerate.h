// Points made to lie on a line, on a plane or on the lattice, or just off: where signs go wrong.
#pragma once

#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <ostream>

#include "kernel/random.h"
#include "kernel/triangles.h"

namespace suture::brute {

class Draws : private suture::Random {
 public:
  using suture::Random::Random;
  std::uint64_t bits() { return next(); }
  /// 0 to n−1; the bias is below n / 2^64.
  int below(int n) { return static_cast<int>(bits() % static_cast<std::uint64_t>(n)); }
  int between(int low, int high) { return low + below(high - low + 1); }
  /// A multiple of 2^-52 in [−1, 1).
  double real() { return static_cast<double>(bits() >> 11) * 0x1p-52 - 1; }
  Point point() {
    const double x = real(), y = real(), z = real();
    return {x, y, z};
  }
};

enum class Family {
  random,          ///< in general position
  small_integers,  ///< 0 to 3: almost everything is degenerate
  lattice,         ///< on rounded planes 0.3 + 0.1 i, one coordinate in eight off by one ulp
  line,            ///< rounded points of one line, up to two ulps off
  plane,           ///< rounded points of one plane, up to two ulps off
  flat,            ///< in one plane across an axis, and rounded points of a line there
  wide,            ///< any exponent that a double can have, zero and subnormals too
  tiny,            ///< small multiples of a power of two at which products underflow
  huge,            ///< small multiples of a power of two at which products or differences overflow
  stretched,       ///< small integers or a plane, each axis scaled by its own power of two
  scaled,          ///< rounded points of a line or plane, of any one size, up to two ulps off
  neighbours,      ///< a few doubles from one point, which has any exponents
};
inline constexpr std::array kFamilies = {
    Family::random, Family::small_integers, Family::lattice, Family::line,
    Family::plane,  Family::flat,           Family::wide,    Family::tiny,
    Family::huge,   Family::stretched,      Family::scaled,  Family::neighbours};

inline const char* name_of(Family family) {
  constexpr const char* kNames[] = {"random", "small_integers", "lattice", "line",
                                    "plane",  "flat",           "wide",    "tiny",
                                    "huge",   "stretched",      "scaled",  "neighbours"};
  return kNames[static_cast<int>(family)];
}

inline std::ostream& operator<<(std::ostream& out, Family family) { return out << name_of(family); }

/// x moved by `steps` doubles.
inline double nudged(double x, int steps) {
  const double to = steps > 0 ? std::numeric_limits<double>::infinity()
                              : -std::numeric_limits<double>::infinity();
  for (int i = 0; i < std::abs(steps); ++i) x = std::nextafter(x, to);
  return x;
}

/// Any finite double, its exponent as likely as any other; one in eight is zero.
inline double any_double(Draws& random) {
  if (random.below(8) == 0) return 0;
  const int exponent = random.between(-1074, 1024);
  return std::ldexp(random.real(), exponent);
}

using Points4 = std::array<Point, 4>;

inline Points4 integers(Draws& random, double scale) {
  Points4 result;
  for (Point& p : result)
    for (double& x : p) x = random.below(4) * scale;
  return result;
}

/// Rounded points of the line (`directions` 1) or plane (2) through a random point.
inline Points4 on_flat(Draws& random, int directions) {
  const Point origin = random.point(), s = random.point(), t = random.point();
  Points4 result;
  for (Point& p : result) {
    const double along = random.below(2) ? random.real() : random.between(-3, 3);
    p = origin + along * s;
    if (directions == 2) p += random.real() * t;
    for (double& x : p) x = nudged(x, random.between(-2, 2));
  }
  return result;
}

inline Points4 near_lattice(Draws& random) {
  Points4 result;
  for (Point& p : result)
    for (double& x : p) {
      x = 0.3 + random.below(4) * 0.1;
      if (random.below(8) == 0) x = nudged(x, random.below(2) ? 1 : -1);
    }
  return result;
}

inline Points4 in_axis_plane(Draws& random) {
  Points4 result = on_flat(random, random.between(1, 2));
  const int axis = random.below(3);
  for (Point& p : result) p[axis] = result[0][axis];
  return result;
}

inline Points4 stretched(Draws& random) {
  Points4 result = random.below(2) ? integers(random, 1) : on_flat(random, 2);
  for (int axis = 0; axis < 3; ++axis) {
    const int exponent = random.between(-1074, 1020);
    for (Point& p : result) p[axis] = std::ldexp(p[axis], exponent);
  }
  return result;
}

/// Nudged after scaling: where the scaling rounds, to subnormals, the nudges are still whole ulps.
inline Points4 scaled(Draws& random) {
  Points4 result = on_flat(random, random.between(1, 2));
  const int exponent = random.between(-1078, 1020);
  for (Point& p : result)
    for (double& x : p) x = nudged(std::ldexp(x, exponent), random.between(-2, 2));
  return result;
}

inline Points4 neighbours(Draws& random) {
  Point base;
  for (double& x : base) x = any_double(random);
  Points4 result{base, base, base, base};
  for (Point& p : result)
    for (double& x : p) x = nudged(x, random.between(-4, 4));
  return result;
}

/// Four finite points. Often some coincide.
inline Points4 near_degenerate(Family family, Draws& random) {
  const auto each = [](auto make) { return Points4{make(), make(), make(), make()}; };
  switch (family) {
    case Family::random:
      return each([&] { return random.point(); });
    case Family::small_integers:
      return integers(random, 1);
    case Family::lattice:
      return near_lattice(random);
    case Family::line:
      return on_flat(random, 1);
    case Family::plane:
      return on_flat(random, 2);
    case Family::flat:
      return in_axis_plane(random);
    case Family::wide: {
      Points4 result;
      for (Point& p : result)
        for (double& x : p) x = any_double(random);
      return result;
    }
    case Family::tiny:
      return integers(random, std::ldexp(1, -random.between(320, 1074)));
    case Family::huge: {
      Points4 result = integers(random, std::ldexp(1, random.between(330, 1022)));
      for (Point& p : result)
        if (random.below(2)) p = -p;
      return result;
    }
    case Family::stretched:
      return stretched(random);
    case Family::scaled:
      return scaled(random);
    case Family::neighbours:
      break;
  }
  return neighbours(random);
}

}  // namespace suture::brute
