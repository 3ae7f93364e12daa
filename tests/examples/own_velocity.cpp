// A velocity field of one's own: two balls are pressed together faster and faster, and become one.
#include <suture/kernel/measure/measures.h>
#include <suture/kernel/shapes/shapes.h>
#include <suture/kernel/shapes/transform.h>
#include <suture/surgery/tracker.h>

#include <cstdio>

namespace {

// Lengths and seconds are the scene's own. The flow keeps volume: div u = 0.
suture::Point press(const suture::Point& p, double t) {
  return 2 * t * suture::Point(-p.x(), p.y() / 2, p.z() / 2);
}

}  // namespace

int main() {
  const suture::Triangles ball = suture::sphere({.radius = 0.6, .edge_length = 0.12});
  const std::vector<suture::Triangles> balls = {suture::translated(ball, {-0.7, 0, 0}),
                                                suture::translated(ball, {0.7, 0.1, 0})};
  suture::TrackerOptions options;
  options.cell_size = 0.12;
  options.origin = {0.06, 0, 0};  // no plane of the lattice lies where the balls meet
  suture::Tracker tracker(suture::merged(balls), options);
  while (tracker.time() < 1.15) {
    tracker.advect(press, 0.1);
    tracker.remodel();
    tracker.improve();
  }
  const std::size_t bodies = suture::components(tracker.surface()).count;
  std::printf("bodies at t = %.1f: %zu\n", tracker.time(), bodies);
  return bodies == 1 ? 0 : 1;
}
