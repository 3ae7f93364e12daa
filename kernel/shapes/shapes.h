// Test bodies: closed, oriented outward, manifold and embedded, at any resolution.
#pragma once

#include "kernel/triangles.h"

namespace suture {

// Lengths are in the scene's unit, and edges are about as long as `edge_length`. Each function
// throws InvalidInput where a parameter is out of its range, or would give more than
// kMostTriangles.

inline constexpr double kMostTriangles = 5e7;

/// An icosahedron with every edge in equal parts, pushed out to the sphere. Its angles are above
/// 50°.
struct SphereParameters {
  Point centre = Point::Zero();
  double radius = 1;
  double edge_length = 0.1;
  int frequency = 0;  ///< n parts of each icosahedron edge, 20·n² triangles; 0: from edge_length
  int exact_volume =
      0;  ///< 1: vertices lie so far out that the volume is the ball's; 0: on the ball
};
Triangles sphere(const SphereParameters& parameters);

/// A box of six grids of right-angled triangles; the sides of their squares are within a factor 2.
struct BoxParameters {
  Point centre = Point::Zero();
  Point size = Point::Constant(1);
  double edge_length = 0.1;
};
Triangles box(const BoxParameters& parameters);

/// A ring round z; `radius` is from its centre to the middle of the tube.
struct TorusParameters {
  Point centre = Point::Zero();
  double radius = 1;
  double tube_radius = 0.4;  ///< less than radius
  double edge_length = 0.1;
};
Triangles torus(const TorusParameters& parameters);

/// A cylinder along z with flat caps; its rims are sharp edges.
struct CylinderParameters {
  Point centre = Point::Zero();
  double radius = 0.5;
  double height = 1;
  double edge_length = 0.1;
};
Triangles cylinder(const CylinderParameters& parameters);

/// Zalesak's sphere: a slot |x| < width/2, y < top is cut through all z of a ball (x, y from its
/// centre). Walls, floor and the curves where they meet the sphere are edges of the mesh; vertices
/// of the walls and the floor lie exactly on their planes.
struct ZalesakParameters {
  Point centre{50, 75, 50};
  double radius = 15;
  double slot_width = 5;  ///< less than the radius
  double slot_top = 10;   ///< height of the slot's floor over the centre, ±0.8 of the radius
  double edge_length = 1;
};
Triangles zalesak(const ZalesakParameters& parameters);

/// Two balls along z joined by a neck, filleted; edges get shorter towards the neck.
struct DumbbellParameters {
  Point centre = Point::Zero();
  double radius = 0.5;
  double distance = 2;       ///< between the balls' centres
  double neck_radius = 0.1;  ///< less than radius
  double fillet = 0.2;       ///< the radius of the round between neck and ball
  double edge_length = 0.05;
};
Triangles dumbbell(const DumbbellParameters& parameters);

/// A plate in the xy plane, `thickness` along z. Bent, it is part of a cylinder about y, and its
/// middle is as long as before. Where it is thinner than edge_length the triangles of its rim are
/// as thin as it is.
struct SheetParameters {
  Point centre = Point::Zero();
  double length = 2;  ///< along x
  double width = 1;   ///< along y
  double thickness = 0.02;
  double bend = 0;  ///< the angle between its two ends in degrees, −300 to 300
  double edge_length = 0.05;
};
Triangles sheet(const SheetParameters& parameters);

/// A ball carved with steep-walled grooves: rings, rosettes and great circles, placed by the seed.
/// Seen from its centre no triangle is hidden or turned, so it never meets itself.
struct CarvedBallParameters {
  Point centre = Point::Zero();
  double radius = 1;
  double depth = 0.22;        ///< the grooves' depth, as a part of the radius, 0 to 0.6
  double groove_width = 0.1;  ///< as a part of the radius, 0.01 to 0.15
  int seed = 1;
  double edge_length = 0.02;
};
Triangles carved_ball(const CarvedBallParameters& parameters);

/// A four-legged animal about 1.7 lengths long: x is ahead, y is up, its feet are at about y = 0.
/// A smooth union of tapered capsules, polygonised on a grid; the legs are its thinnest parts.
struct AnimalParameters {
  Point centre = Point::Zero();  ///< on the ground below the middle of its body
  double length = 1;             ///< scales all of it
  double leg_radius = 0.035;     ///< the lower legs', as a part of the length, 0.02 to 0.06
  double edge_length = 0.02;     ///< at most 0.6 of the legs' radius
};
Triangles animal(const AnimalParameters& parameters);

/// A hand with its fingers spread, cut off below the wrist, about 1.4 lengths long: fingers along
/// x, the thumb to y, the palm down, −z. It is made as the animal is; its fingers are its thinnest
/// parts.
struct HandParameters {
  Point centre = Point::Zero();  ///< the middle of the wrist
  double length = 1;             ///< from the wrist to the longest finger's tip
  double finger_radius = 0.036;  ///< as a part of the length, 0.025 to 0.05
  double edge_length = 0.015;    ///< at most 0.45 of the fingers' radius
};
Triangles hand(const HandParameters& parameters);

}  // namespace suture
