// Semi-Lagrangian contouring's options: meaning, unit, range and source of each.
#include "sims/baselines/contouring/contouring_options.h"

#include "sims/baselines/grid/lattice_options.h"

namespace suture::sims {
namespace {

using C = ContouringOptions;
const OptionTable<C> kContouring(
    "method", {{"cell_size", &C::cell_size, kCellSize},
               {"origin", &C::origin, kOrigin},
               {"trace_order", &C::trace_order, kTraceOrder},
               {"refinements",
                &C::refinements,
                {.meaning = "evaluations of the exact function that find a vertex on a lattice "
                            "edge; 0: vertices are where a linear function is zero",
                 .range = Range::between(0, 100)}}});

}  // namespace

const OptionTable<ContouringOptions>& contouring_options() { return kContouring; }

}  // namespace suture::sims
