// A failing case becomes a small one that fails alike: fewer operations, fewer triangles, rounder
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

/// How the minimiser tries a case.
struct Trials {
  /// Whether a case still fails as the first one did.
  std::function<bool(const FuzzCase&)> still_fails;

  /// The surface that an operation is given, by the operation's index; empty if the case ends
  /// before it.
  std::function<Triangles(const FuzzCase&, std::size_t)> surface_before;
};

struct Minimised {
  FuzzCase fuzz_case;
  int trials = 0;  ///< cases tried
};

/// The smallest case that was found within the limits; it fails. \pre trials.still_fails(c)
Minimised minimise(FuzzCase c, const Trials& trials, const MinimiseLimits& limits);

}  // namespace suture::sims
