// The table of the options of volume control.
#include "sims/fluid/effects/volume_control.h"

namespace suture::sims {
namespace {

using V = VolumeControlOptions;
const OptionTable<V> kVolumeControl(
    "fluid.volume_control",
    {{"relaxation",
      &V::relaxation,
      {.meaning = "steps in which an error of volume falls to 1/e",
       .unit = unit::steps,
       .range = Range::above(2),
       .source = "Kim et al. 2007"}},
     {"damping",
      &V::damping,
      {.meaning = "damping of the loop with its integral part",
       .range = Range::above(0),
       .source = "Kim et al. 2007"}},
     {"most_shift",
      &V::most_shift,
      {.meaning = "the most that control moves a body's surface in a step",
       .unit = unit::cells,
       .range = Range{0, 1, true}}},
     {"most_integral",
      &V::most_integral,
      {.meaning = "the relative error that the integral part counts as at most",
       .range = Range::between(0, 1)}}});

}  // namespace

const OptionTable<V>& volume_control_options() { return kVolumeControl; }

}  // namespace suture::sims
