// A real number as two doubles and a bound on the error: about 100 bits, and the question whether
// they settle a rounding.
//
// With u = 2^-53 and rounding to nearest, an operation's own error is a few u² of its operands or
// its result; kOwn = 16u² of them covers the sum of such terms below and what is O(u³). Underflow
// adds at most a few 2^-1074 to a product or a quotient: kTiny. kGrow covers that bounds are
// rounded too. Overflow makes a value or its bound infinite or NaN, and `settled` then says no.
#pragma once

#include <cmath>
#include <limits>
#include <optional>

namespace suture {

/// |exact − (high + low)| <= error, and high is the double nearest to high + low.
struct Ball {
  double high = 0, low = 0, error = 0;
};

inline constexpr double kBallOwn = 0x1p-102;
inline constexpr double kBallTiny = 0x1p-1000;
inline constexpr double kBallGrow = 1 + 0x1p-48;

/// x + y, exactly (Knuth's two-sum). \pre no overflow
inline Ball exact_sum(double x, double y) {
  const double sum = x + y, part = sum - x;
  return {sum, (x - (sum - part)) + (y - part), 0};
}

inline Ball operator-(const Ball& x) { return {-x.high, -x.low, x.error}; }

/// Own error, with M = |x| + |y|: u²M from the sum of the low parts, 2u²M from adding it.
inline Ball operator+(const Ball& x, const Ball& y) {
  const Ball sum = exact_sum(x.high, y.high);
  Ball result = exact_sum(sum.high, sum.low + (x.low + y.low));
  const double own = kBallOwn * (std::abs(x.high) + std::abs(y.high));
  result.error = kBallGrow * (own + x.error + y.error);
  return result;
}

inline Ball operator-(const Ball& x, const Ball& y) { return x + -y; }

/// Own error, with P = |xy|: u²P left out, u²P in each cross product, 2u²P and 3u²P in two sums.
inline Ball operator*(const Ball& x, const Ball& y) {
  const double product = x.high * y.high;
  const double rest = std::fma(x.high, y.high, -product);
  Ball result = exact_sum(product, rest + (x.high * y.low + x.low * y.high));
  const double own = kBallOwn * std::abs(product) + kBallTiny;
  const double passed = std::abs(x.high) * y.error + std::abs(y.high) * x.error + x.error * y.error;
  result.error = kBallGrow * (own + passed);
  return result;
}

/// Own error: that of the remainder over |y|, and below 4u of the second quotient. What the
/// operands' errors add is over |y| − y.error, at least half of |y| or the bound is infinite.
inline Ball operator/(const Ball& x, const Ball& y) {
  const double first = x.high / y.high, size = std::abs(y.high);
  const Ball rest = Ball{x.high, x.low, 0} - Ball{first, 0, 0} * Ball{y.high, y.low, 0};
  const double second = rest.high / y.high;
  Ball result = exact_sum(first, second);
  const double own = rest.error / size + 0x1p-51 * std::abs(second) + kBallTiny;
  const double quotient = std::abs(first) + std::abs(second) + own;
  result.error = y.error <= size / 2 ? kBallGrow * (own + 2 * (x.error + quotient * y.error) / size)
                                     : std::numeric_limits<double>::infinity();
  return result;
}

/// The double nearest to the exact number, where the bound leaves only one (Ziv's test).
inline std::optional<double> settled(const Ball& x) {
  if (x.error == 0 && x.low == 0) return x.high;
  const double margin = kBallGrow * x.error + 0x1p-52 * std::abs(x.low) + kBallTiny;
  const double up = x.high + (x.low + margin), down = x.high + (x.low - margin);
  if (up == down) return up;
  return std::nullopt;
}

}  // namespace suture
