// From a failing case to a small one that fails alike: fewer operations, fewer triangles, rounder
// numbers.
#pragma once

#include <functional>

#include "sims/fuzz/fuzz_case.h"

namespace suture::sims {

struct MinimiseLimits {
  double seconds = 20;  ///< on one case
  int trials = 4000;    ///< cases tried for one
  int each = 3;         ///< failures of one kind that are minimised and saved
};

/// Whether a case still fails as the first one did.
using StillFails = std::function<bool(const FuzzCase&)>;

/// The surface that a case's operation is given, by its index; empty if it does not come so far.
using SurfaceBefore = std::function<Triangles(const FuzzCase&, std::size_t)>;

struct Minimised {
  FuzzCase fuzz_case;
  int trials = 0;  ///< cases tried
};

/// The smallest case that was found within the limits; it fails. \pre still_fails(c)
Minimised minimise(FuzzCase c, const StillFails& still_fails, const SurfaceBefore& surface_before,
                   const MinimiseLimits& limits);

}  // namespace suture::sims
