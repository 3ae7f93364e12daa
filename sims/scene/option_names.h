// The words by which users choose among the tracker's options, on the command line and in scenes.
#pragma once

#include <array>

#include "sims/support/keys.h"
#include "surgery/model/options.h"

namespace suture::sims {

inline constexpr std::array<Named<Events>, 4> kEventsNames = {{{"merge", Events::merge},
                                                               {"split", Events::split},
                                                               {"both", Events::both},
                                                               {"none", Events::none}}};
inline constexpr std::array<Named<CellTest>, 2> kCellTestNames = {
    {{"deep", CellTest::deep}, {"plain", CellTest::plain}}};
inline constexpr std::array<Named<Collapse>, 3> kCollapseNames = {
    {{"straighten", Collapse::straighten}, {"keep", Collapse::keep}, {"paper", Collapse::paper}}};
inline constexpr std::array<Named<Placement>, 2> kPlacementNames = {
    {{"distance_field", Placement::distance_field}, {"crossing", Placement::crossing}}};
inline constexpr std::array<Named<Arithmetic>, 3> kArithmeticNames = {
    {{"rounded", Arithmetic::rounded},
     {"filtered", Arithmetic::filtered},
     {"rational", Arithmetic::rational}}};
inline constexpr std::array<Named<Subdivision>, 3> kSubdivisionNames = {
    {{"midpoint", Subdivision::midpoint},
     {"curved", Subdivision::curved},
     {"fitted", Subdivision::fitted}}};

}  // namespace suture::sims
