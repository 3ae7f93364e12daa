// A surgery with which nothing is wrong, until a test says so.
#pragma once

#include "kernel/shapes/shapes.h"
#include "kernel/shapes/transform.h"
#include "sims/fuzz/observation.h"
#include "surgery/tracker.h"

namespace suture::sims {

/// Two balls that overlap, and the surface that a remodel makes of them.
struct Healthy {
  TrackerOptions options;
  Triangles before, after;
  SurgeryReport surgery;

  Healthy() {
    options.cell_size = 0.31;
    options.collapse = Collapse::keep;
    before = merged(std::vector<Triangles>{sphere({Point(0.01, 0.02, 0.03), 1, 0.1, 3}),
                                           sphere({Point(1.11, 0.12, 0.23), 0.8, 0.1, 3})});
    Tracker tracker(before, options);
    surgery = tracker.remodel();
    after = tracker.surface();
  }
  Observation seen() const { return {1, options, before, after, &surgery, nullptr, true}; }
};

}  // namespace suture::sims
