// Everything a user can choose about the tracker, with its default and its reason.
#pragma once

#include "kernel/triangles.h"
#include "predicates/oracle.h"

namespace suture {

/// The topology changes that are allowed [§5.3]: deep cells inside the material merge, outside they
/// split.
enum class Events { none, merge, split, both };

/// The complex cells that start a region: only deep ones [§5.3], or each of them (Figure 4
/// compares).
enum class CellTest { deep, plain };

/// The fate of type 2 vertices, and its time [§6.1 step 3, §6.2].
enum class Collapse {
  straighten,  ///< they collapse after the fill: nothing can gridlock
  /// None goes. Outside the region old vertices stay to the last bit, and so do triangles but for
  /// those beside split triangles: pieces with rounded vertices take their place.
  keep,
  paper  ///< they collapse before the fill; on gridlock the region grows and all starts again
};

/// The place of the fill's own vertices along their lattice edge [§6.1 step 5].
enum class Placement {
  /// The zero of D between its two nodes, as the paper does. D is the distance to any sheet: one
  /// that is about to be swallowed is often the nearest to an inside node, and draws the vertex
  /// inwards.
  distance_field,
  crossing  ///< the exact point where the mesh passes from outside to inside
};

/// The place of a new vertex of subdivision [§6.2].
enum class Subdivision {
  midpoint,  ///< flattens curved surfaces a little each time
  curved,    ///< on the cubic that the edge's end points and normals define
  /// It is on a polynomial surface fitted to the two rings around the edge, and collapses leave
  /// vertices where they are. So what the flow moved stays where the flow took it: for smooth
  /// surfaces, of which the mesh's vertices are samples.
  fitted
};

/// Mesh improvement [§6.2]. Lengths are in the scene's unit.
struct QualityOptions {
  double edge_length = 0;  ///< the length aimed at; 0: the cell size of the tracker
  /// Edges aim at the length whose middle is this far from a curved surface; 0: at edge_length
  /// everywhere [Dunyach et al. 2013].
  double chord_error = 0;
  double finest = 0.25;        ///< × edge_length: the least length that curvature may ask for
  double longest = 1.5;        ///< edges above longest × edge_length are subdivided
  double shortest = 0.4;       ///< edges below shortest × edge_length are collapsed
  double smallest_angle = 15;  ///< degrees; a triangle with a smaller angle is bad
  double largest_angle = 150;  ///< degrees; a triangle with a larger angle is bad
  /// Degrees between normals; a sharper edge is a feature and is kept, unless it is shorter than
  /// half of shortest × edge_length.
  double feature_angle = 40;
  bool keep_features = true;   ///< off: features may be rounded by collapses and flips
  double volume_bound = 0.03;  ///< × edge_length³: the most volume that one operation may move
  double turn_bound = 60;      ///< degrees: the most a triangle's normal may turn in one operation
  int passes = 3;  ///< sweeps of subdivide, collapse, flip; ends early when nothing is left
  Subdivision subdivision = Subdivision::midpoint;
};

struct TrackerOptions {
  double cell_size = 0;          ///< edge of a topology cell; must be set
  Point origin = Point::Zero();  ///< a node of the lattice, so that the lattice stays put in space
  Events events = Events::both;
  CellTest cell_test = CellTest::deep;
  int depth = 1;  ///< whole cells that a deep cell is away from the isosurface, >= 0
  Collapse collapse = Collapse::straighten;
  int most_restarts = 100;  ///< of `Collapse::paper`: after so many gridlocks surgery is refused
  Placement placement =
      Placement::crossing;  ///< D is −0.46 % off on two horses at 128, this −0.04 %
  Arithmetic arithmetic = Arithmetic::filtered;
  /// With `rounded` only: each remodel works on vertices moved at random by up to this part of a
  /// cell on each axis, the paper's remedy against degeneracy [§5.3]; 0: none, at most 0.1.
  double jitter = 1e-6;
  double straighten_turn = 60;  ///< degrees: the most a normal may turn when a type 2 vertex goes
  QualityOptions quality{};
};

}  // namespace suture
