// The tables of the tracker's options: meaning, unit, range and source of each.
#include "surgery/model/option_table.h"

namespace suture {

namespace {

using T = TrackerOptions;
const OptionTable<T> kTrackerOptions(
    "tracker",
    {{"cell_size",
      &T::cell_size,
      {.meaning = "edge of a topology cell",
       .unit = unit::length,
       .range = Range::above(0),
       .required = true,
       .source = "§5.1"}},
     {"origin",
      &T::origin,
      {.meaning = "a node of the lattice, so that the lattice stays put in space",
       .unit = unit::length,
       .source = "§5.1"}},
     {"events",
      {&T::events, kEventsNames},
      {.meaning = "topology changes that are allowed: deep cells inside the material merge, deep "
                  "cells outside split",
       .source = "§5.3"}},
     {"cell_test",
      {&T::cell_test, kCellTestNames},
      {.meaning = "complex cells that start a region: only deep ones, or plainly each of them",
       .source = "§5.3, Figure 4"}},
     {"depth",
      &T::depth,
      {.meaning = "whole cells that a deep cell is away from the isosurface",
       .unit = unit::cells,
       // (2·depth + 1)³ cells are looked at for each complex cell.
       .range = Range::between(0, 1000),
       .source = "§5.3"}},
     {"collapse",
      {&T::collapse, kCollapseNames},
      {.meaning = "vertices on the region's boundary: straighten collapses them after the fill, "
                  "keep keeps them all, paper collapses them before the fill and grows the "
                  "region on gridlock",
       .source = "§6.1 step 3, §6.2"}},
     {"placement",
      {&T::placement, kPlacementNames},
      {.meaning = "new vertices: where the mesh crosses the lattice edge, or at the zero of the "
                  "distance field, as in the paper",
       .source = "§6.1 step 5"}},
     {"arithmetic",
      {&T::arithmetic, kArithmeticNames},
      {.meaning = "signs: filtered is exact, rational is exact and slow, rounded is plain "
                  "doubles and may fail",
       .source = "§5.3"}},
     {"jitter",
      &T::jitter,
      {.meaning = "with rounded arithmetic only: each remodel works on vertices moved at random "
                  "by up to this part of a cell on each axis; 0: none",
       .unit = unit::cells,
       .range = Range::between(0, 0.1),
       .source = "§5.3"}},
     {"most_restarts",
      &T::most_restarts,
      {.meaning = "with collapse = paper only: gridlocks after which the surgery is refused",
       .range = Range::at_least(0),
       .source = "§6.2"}},
     {"straighten_turn",
      &T::straighten_turn,
      {.meaning = "the most that a normal may turn when a vertex of the region's boundary goes",
       .unit = unit::degrees,
       .range = Range::between(0, 180)}}});

using Q = QualityOptions;
constexpr Unit kEdges{"× edge_length"}, kCubes{"× edge_length³"};
const OptionTable<Q> kQualityOptions(
    "quality",
    {{"edge_length",
      &Q::edge_length,
      {.meaning = "the length that edges aim at; 0: the tracker's cell_size",
       .unit = unit::length,
       .range = Range::at_least(0),
       .source = "§6.2"}},
     {"chord_error",
      &Q::chord_error,
      {.meaning = "where the surface is curved, edges aim at the length whose middle is this far "
                  "from it; 0: at edge_length everywhere",
       .unit = unit::length,
       .range = Range::at_least(0),
       .source = "Dunyach et al. 2013"}},
     {"finest",
      &Q::finest,
      {.meaning = "the least length that curvature may ask for",
       .unit = kEdges,
       .range = Range{0, 1, true},
       .source = "Dunyach et al. 2013"}},
     {"longest",
      &Q::longest,
      {.meaning = "longer edges are subdivided",
       .unit = kEdges,
       .range = Range::above(1),
       .source = "§6.2"}},
     {"shortest",
      &Q::shortest,
      {.meaning = "shorter edges are collapsed",
       .unit = kEdges,
       .range = Range::between(0, 1),
       .source = "§6.2"}},
     {"smallest_angle",
      &Q::smallest_angle,
      {.meaning = "a triangle with a smaller angle is bad",
       .unit = unit::degrees,
       .range = Range::between(0, 60),
       .source = "§6.2"}},
     {"largest_angle",
      &Q::largest_angle,
      {.meaning = "a triangle with a larger angle is bad",
       .unit = unit::degrees,
       .range = Range::between(60, 180),
       .source = "§6.2"}},
     {"feature_angle",
      &Q::feature_angle,
      {.meaning = "an edge between normals further apart is a feature",
       .unit = unit::degrees,
       .range = Range::between(0, 180)}},
     {"keep_features",
      &Q::keep_features,
      {.meaning = "features are kept; else collapses and flips may round them"}},
     {"volume_bound",
      &Q::volume_bound,
      {.meaning = "the most volume that one operation may move",
       .unit = kCubes,
       .range = Range::at_least(0)}},
     {"turn_bound",
      &Q::turn_bound,
      {.meaning = "the most that a triangle's normal may turn in one operation",
       .unit = unit::degrees,
       .range = Range::between(0, 180)}},
     {"passes",
      &Q::passes,
      {.meaning = "rounds of subdividing, collapsing and flipping; fewer where nothing is left "
                  "to do",
       .range = Range::between(0, 1000),
       .source = "§6.2"}},
     {"subdivision",
      {&Q::subdivision, kSubdivisionNames},
      {.meaning = "a new vertex: midpoint of the edge; curved, on the cubic through the edge's "
                  "ends and normals; fitted, on a surface fitted to the two rings around the "
                  "edge, where collapses move no vertex",
       .source = "§6.2"}}});

}  // namespace

const OptionTable<TrackerOptions>& tracker_options() { return kTrackerOptions; }
const OptionTable<QualityOptions>& quality_options() { return kQualityOptions; }

}  // namespace suture
