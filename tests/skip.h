// A test that cannot run here says so, and CTest counts it as skipped: not as passed.
#pragma once

#include <catch2/catch.hpp>
#include <string>

namespace suture {

/// The reason why the test case that runs now is skipped; empty where it is not.
/// tests/test_main.cpp prints it behind the words that CTest looks for, unless the test case has
/// failed.
inline std::string& skip_reason() {
  static std::string reason;
  return reason;
}

}  // namespace suture

/// Ends a test case that lacks what it needs: SUTURE_SKIP("horse.ply is not at hand").
#define SUTURE_SKIP(reason)           \
  do {                                \
    suture::skip_reason() = (reason); \
    SUCCEED(reason);                  \
    return;                           \
  } while (false)
