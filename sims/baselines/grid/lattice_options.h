// What the options that several baselines have mean.
#pragma once

#include "kernel/option.h"

namespace suture::sims {

inline const OptionInfo kCellSize{.meaning = "edge of a cell of the method's lattice",
                                  .unit = unit::length,
                                  .range = Range::above(0),
                                  .otherwise = "that of [tracker]"};
inline const OptionInfo kOrigin{
    .meaning = "a node of the lattice", .unit = unit::length, .otherwise = "that of [tracker]"};
inline const OptionInfo kTimeOrder{.meaning = "order of the TVD Runge–Kutta method of upwind steps",
                                   .range = Range::between(1, 3),
                                   .source = "Shu and Osher 1988"};
inline const OptionInfo kTraceOrder{.meaning = "order of the Runge–Kutta method for paths",
                                    .range = Range::between(2, 4)};

}  // namespace suture::sims
