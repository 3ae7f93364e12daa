// The processor is looked at as it computes, since both settings are a thread's own.
#include "predicates/floating_point.h"

#include <cfloat>
#include <limits>

#include "kernel/errors.h"

namespace suture {

static_assert(FLT_EVAL_METHOD == 0, "doubles must be computed as doubles; use SSE2, not x87");
static_assert(std::numeric_limits<double>::is_iec559, "doubles must be IEEE's; no -ffast-math");

namespace {

// Volatile, so that the processor computes these and not the compiler.
bool rounds_to_nearest() {
  volatile double one = 1, less_than_half_ulp = 0x1p-54;
  const volatile double up = one + less_than_half_ulp, down = -one - less_than_half_ulp,
                        to_zero = one - less_than_half_ulp / 2;
  return up == 1 && down == -1 && to_zero == 1;
}

bool keeps_subnormals() {
  volatile double smallest = std::numeric_limits<double>::min(), half = 0.5;
  const volatile double subnormal = smallest * half, doubled = subnormal / half;
  return doubled == smallest;
}

}  // namespace

void require_ieee_arithmetic() {
  if (!rounds_to_nearest())
    throw InvalidInput(
        "this thread does not round doubles to nearest, so no sign can be trusted; call "
        "std::fesetround(FE_TONEAREST) first");
  if (!keeps_subnormals())
    throw InvalidInput(
        "this thread flushes subnormal doubles to zero, so no sign can be trusted; undo that first "
        "(on x86 clear bits 0x8040 of MXCSR; a library linked with -ffast-math may have set them)");
}

}  // namespace suture
