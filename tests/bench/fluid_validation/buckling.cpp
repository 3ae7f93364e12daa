// A column of thick liquid that stands on a floor and buckles under its weight.
#include "tests/bench/fluid_validation/validation.h"
#include "tests/sims/fluid/runs.h"

namespace suture {

void buckling(Rows& rows) {
  for (const double cell : {1.0 / 30, 1.0 / 50}) {
    rows.restart();
    ThickColumn column(cell);
    for (int i = 0; i <= 40; ++i) {
      if (i > 0) column.run.frame(0.05);
      rows.add("_height", 1 / cell, 0.05 * i, column.height(), 1);
      rows.add("_aside", 1 / cell, 0.05 * i, column.aside(), 0);
    }
  }
}

}  // namespace suture
