// The README's program; a test compares the two.
#include <suture/kernel/formats/mesh_io.h>
#include <suture/surgery/tracker.h>

#include <cstdio>

// A flow that spins faster near the axis, so that bodies apart are drawn past one another.
suture::Point velocity(const suture::Point& p, double /*t*/) {
  const double spin = 1 / (1 + p.x() * p.x() + p.y() * p.y());
  return {-spin * p.y(), spin * p.x(), 0};
}

int main() {
  const double dt = 0.05;
  suture::TrackerOptions options;
  options.cell_size = 0.1;
  suture::Tracker tracker(suture::read_triangles("out/union.ply"), options);
  while (tracker.time() < 2.0) {
    tracker.advect(velocity, dt);  // RK4 through u(x, t); or displace(positions)
    const suture::SurgeryReport report = tracker.remodel();  // splits and merges where due
    if (report.outcome == suture::Outcome::refused) std::puts(report.failure.c_str());
    tracker.improve();  // subdivides, collapses, flips
  }
  suture::write_triangles("out/moved.ply", tracker.surface());
}
