// Bodies that move rigidly, and share their momentum once they have merged.
#pragma once

#include <memory>

#include "sims/flows/motion.h"

namespace suture::sims {

/// Every vertex has a velocity of its own, at first its body's; so bodies move rigidly and into
/// each other. Within a connected component velocities relax towards their mean, weighted by area,
/// with the time constant `relaxation`: what has merged comes to move as one. \param velocities one
/// for each vertex of the surface that it begins with
std::unique_ptr<Motion> make_bodies_motion(std::vector<Point> velocities, double relaxation);

}  // namespace suture::sims
