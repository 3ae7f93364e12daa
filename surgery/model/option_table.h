// The tables of the tracker's options: who adds an option adds a field to options.h and a row here.
#pragma once

#include "kernel/option_table.h"
#include "surgery/model/options.h"

namespace suture {

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

/// The options of remodels. Those of `quality` have a table of their own.
const OptionTable<TrackerOptions>& tracker_options();

/// The options of improvements.
const OptionTable<QualityOptions>& quality_options();

}  // namespace suture
