// An oracle refuses a processor whose settings its bounds do not hold for.
#include "predicates/floating_point.h"

#include <catch2/catch.hpp>
#include <cfenv>
#ifdef __SSE2__
#include <xmmintrin.h>
#endif

#include "kernel/errors.h"
#include "predicates/oracle.h"

using namespace suture;

namespace {

/// The complaint about this rounding mode, which is undone before anything is checked.
std::string complaint() {
  try {
    make_filtered_oracle();
  } catch (const InvalidInput& error) {
    return error.what();
  }
  return "";
}

std::string complaint_when_rounding(int mode) {
  std::fesetround(mode);
  const std::string said = complaint();
  std::fesetround(FE_TONEAREST);
  return said;
}

}  // namespace

TEST_CASE("an oracle wants doubles rounded to nearest") {
  CHECK(complaint_when_rounding(FE_TONEAREST) == "");
  for (const int mode : {FE_UPWARD, FE_DOWNWARD, FE_TOWARDZERO}) {
    INFO(mode);
    CHECK_THAT(complaint_when_rounding(mode), Catch::Contains("fesetround"));
  }
}

#ifdef __SSE2__
TEST_CASE("an oracle wants subnormal doubles kept") {
  const unsigned before = _mm_getcsr();
  for (const unsigned bit : {0x8000u, 0x0040u}) {  // results flushed; operands taken for zero
    _mm_setcsr(before | bit);
    const std::string said = complaint();
    _mm_setcsr(before);
    INFO(bit);
    CHECK_THAT(said, Catch::Contains("subnormal"));
  }
}
#endif
