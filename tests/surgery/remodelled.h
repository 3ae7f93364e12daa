// One remodel that must go through and leave a closed manifold.
#pragma once

#include <catch2/catch.hpp>

#include "tests/surgery/support.h"

namespace suture {

using namespace suture::surgery;

struct Remodelled {
  Triangles surface;
  SurgeryReport report;
};

inline Remodelled remodelled(const Triangles& surface, const TrackerOptions& options) {
  Tracker tracker(surface, options);
  SurgeryReport report = tracker.remodel();
  INFO(report.failure);
  CHECK(report.outcome != Outcome::refused);
  const Audit result = audit(tracker.surface());
  INFO(result.first);
  CHECK(result.closed_manifold());
  return {tracker.surface(), std::move(report)};
}

}  // namespace suture
