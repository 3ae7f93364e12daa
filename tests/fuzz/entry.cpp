// libFuzzer's entry: one program a target, which the build names in SUTURE_FUZZ_TARGET.
#include <cstddef>
#include <cstdint>

#include "tests/fuzz/targets.h"

// A Finding is not caught: the fuzzer saves the bytes that led to it and says what it was.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  suture::fuzz::SUTURE_FUZZ_TARGET({reinterpret_cast<const char*>(data), size});
  return 0;
}
