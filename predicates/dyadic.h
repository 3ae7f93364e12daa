// Doubles as GMP integers over one power of two, without any rounding.
#pragma once

#include <gmpxx.h>

#include <algorithm>
#include <cmath>
#include <initializer_list>
#include <limits>

namespace suture {

/// The exponent e of the coarsest grid 2^e that holds every one of `values`, at least -1074; 0 if
/// all are zero. \pre finite
inline int grid_exponent(std::initializer_list<double> values) {
  constexpr int kFinest = std::numeric_limits<double>::min_exponent - 53;
  int exponent = std::numeric_limits<int>::max();
  for (double x : values)
    if (x != 0) exponent = std::min(exponent, std::max(std::ilogb(x) - 52, kFinest));
  return exponent == std::numeric_limits<int>::max() ? 0 : exponent;
}

/// x / 2^exponent. \pre x is a whole multiple of 2^exponent
inline mpz_class on_grid(double x, int exponent) {
  int own = 0;
  mpz_class result(std::ldexp(std::frexp(x, &own), 53));
  const int shift = own - 53 - exponent;
  if (shift >= 0)
    result <<= static_cast<unsigned>(shift);
  else
    result >>= static_cast<unsigned>(-shift);  // exact: a multiple of the grid has these bits zero
  return result;
}

}  // namespace suture
