// The predicates and positions against rationals, on points that the bytes build nearly degenerate.
#include <cmath>
#include <cstdio>
#include <cstring>
#include <string>

#include "predicates/oracle.h"
#include "tests/brute/construct_questions.h"
#include "tests/fuzz/targets.h"

namespace suture::fuzz {

namespace {

using brute::Points4;

/// Bytes from the front; zeros once they have run out.
class Bytes {
 public:
  explicit Bytes(std::string_view bytes) : rest_(bytes) {}
  template <class T>
  T take() {
    char raw[sizeof(T)] = {};
    const std::size_t n = std::min(sizeof(T), rest_.size());
    std::memcpy(raw, rest_.data(), n);
    rest_.remove_prefix(n);
    T value;
    std::memcpy(&value, raw, sizeof(T));
    return value;
  }
  int below(int n) { return take<std::uint8_t>() % n; }

 private:
  std::string_view rest_;
};

/// Any bits, a small whole number, one times a power of two, or a power of two.
double number(Bytes& bytes) {
  switch (bytes.below(4)) {
    case 0: {
      const double x = bytes.take<double>();
      return std::isfinite(x) ? x : 0;
    }
    case 1:
      return bytes.take<std::int8_t>();
    case 2: {
      const int factor = bytes.take<std::int8_t>();
      return std::ldexp(factor, std::clamp<int>(bytes.take<std::int16_t>(), -1074, 1016));
    }
    default:
      return std::ldexp(1, std::clamp<int>(bytes.take<std::int16_t>(), -1074, 1023));
  }
}

/// Overflow may not leave the doubles: predicates are promised for finite ones only.
Point finite(Point p) {
  for (double& x : p)
    if (!std::isfinite(x)) x = 0;
  return p;
}

/// The next point: of its own, or on the line or plane of those before, up to two doubles off.
Point next_point(Bytes& bytes, const Points4& known, int count) {
  const auto earlier = [&] { return known[bytes.below(std::max(count, 1))]; };
  Point p = Point::Zero();
  switch (bytes.below(5)) {
    case 0:
      for (double& x : p) x = number(bytes);
      break;
    case 1:
      p = earlier();
      p[bytes.below(3)] = number(bytes);
      break;
    case 2: {
      const Point a = earlier(), b = earlier();
      p = a + number(bytes) * (b - a);
      break;
    }
    case 3: {
      const Point a = earlier(), b = earlier(), c = earlier();
      const double s = number(bytes);
      p = a + s * (b - a) + number(bytes) * (c - a);
      break;
    }
    default:
      for (double& x : p) x = earlier()[bytes.below(3)];
  }
  if (const int how = bytes.take<std::uint8_t>(); how != 0)
    for (int axis = 0; axis < 3; ++axis)
      p[axis] = brute::nudged(p[axis], (how >> (2 * axis)) % 4 - 1);
  return finite(p);
}

std::string show(const Points4& points) {
  std::string text;
  char digits[40];
  for (const Point& p : points)
    for (const double x : p) {
      std::snprintf(digits, sizeof digits, "%a ", x);
      text += digits;
    }
  return text;
}

void require(bool holds, const char* what, const Points4& points) {
  if (!holds) throw Finding(std::string("predicates: ") + what + ": " + show(points));
}

struct Twins {
  std::unique_ptr<Oracle> filtered = make_filtered_oracle(), rational = make_rational_oracle();
};

void compare_signs(const Points4& p, int axis) {
  static const Twins oracles;
  const Oracle &fast = *oracles.filtered, &exact = *oracles.rational;
  const int u = next_axis(axis), v = prev_axis(axis);
  for (const LatticePoint2& at :
       {LatticePoint2{u, v, p[2][u], p[2][v]}, LatticePoint2{v, u, p[2][v], p[2][u]}})
    require(fast.edge_side(p[0], p[1], at) == exact.edge_side(p[0], p[1], at), "edge_side", p);
  require(fast.triangle_side(p[0], p[1], p[2], p[3]) == exact.triangle_side(p[0], p[1], p[2], p[3]),
          "triangle_side", p);
  require(fast.orientation(p[0], p[1], p[2], p[3]) == exact.orientation(p[0], p[1], p[2], p[3]),
          "orientation", p);
}

void compare_positions(const Points4& p, int axis) {
  const auto check = [&](const auto& question, const char* what) {
    if (brute::crosses(question))
      require(brute::is_nearest(brute::ask(question), brute::exact(question)), what, p);
  };
  check(brute::EdgeQuestion{p[0], p[1], axis, next_axis(axis), p[2][axis]},
        "on_edge is not the nearest double");
  check(brute::TriangleQuestion{p, axis}, "on_triangle is not the nearest double");
}

}  // namespace

void compare_predicates(std::string_view input) {
  Bytes bytes(input);
  const int how = bytes.take<std::uint8_t>(), axis = how % 3;
  Points4 points;
  for (int i = 0; i < 4; ++i) points[i] = next_point(bytes, points, i);
  // One question a case: the fuzzer then sees which bytes lead where.
  if (how / 3 % 2 == 0)
    compare_signs(points, axis);
  else
    compare_positions(points, axis);
}

}  // namespace suture::fuzz
