// The one Catch2 main that every test program links, and what tells CTest of skipped tests.
#define CATCH_CONFIG_MAIN
#include <catch2/catch.hpp>
#include <iostream>

#include "tests/skip.h"

namespace {

struct SkippedTests : Catch::TestEventListenerBase {
  using TestEventListenerBase::TestEventListenerBase;

  void testCaseStarting(const Catch::TestCaseInfo&) override { suture::skip_reason().clear(); }
  void testCaseEnded(const Catch::TestCaseStats& stats) override {
    if (!suture::skip_reason().empty() && stats.totals.assertions.allPassed())
      std::cout << "SKIPPED: " << stats.testInfo.name << ": " << suture::skip_reason() << '\n';
  }
};

}  // namespace

CATCH_REGISTER_LISTENER(SkippedTests)
