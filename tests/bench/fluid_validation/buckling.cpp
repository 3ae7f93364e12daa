// A column of thick liquid between a floor and a plate that comes down: it buckles.
#include <cmath>

#include "tests/bench/fluid_validation/equal_steps.h"
#include "tests/bench/fluid_validation/validation.h"

namespace suture {

using namespace suture::sims;

/// Times are parts by which it is shorter. The rate at which the bend grows is between shortenings
/// of 0.02 and 0.06, beyond which the bend is not small against the width.
void buckling(Rows& rows) {
  constexpr int kParts = 5;  // the bend grows by a third in 0.1, which one step does not resolve
  for (const int cells : {30, 40, 60}) {
    rows.restart();
    PressedColumn column(1.0 / cells);
    double from = 0, slender_from = 0;
    for (int i = 0; i <= 30; ++i) {
      for (int part = 0; i > 0 && part < kParts; ++part)
        frame_of_equal_steps(column.run, 0.1 / kParts);
      const double shorter = 1 - column.height(), aside = column.aside();
      rows.add("_aside", cells, shorter, aside / column.width, column.slender() / column.width);
      if (i == 2) {
        from = std::log(aside);
        slender_from = std::log(column.slender());
      }
      if (i == 6)
        rows.add("_rate", cells, shorter, std::log(aside) - from,
                 std::log(column.slender()) - slender_from);
    }
    rows.add("_volume", cells, 0.3, column.run.volume(), 0.01);
  }
}

}  // namespace suture
