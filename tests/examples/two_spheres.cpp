// Two spheres that overlap become one body by one remodel.
#include <suture/kernel/formats/mesh_io.h>
#include <suture/kernel/shapes/shapes.h>
#include <suture/kernel/shapes/transform.h>
#include <suture/surgery/tracker.h>

#include <cstdio>

int main() {
  const std::vector<suture::Triangles> spheres = {
      suture::sphere({.radius = 1, .edge_length = 0.1}),
      suture::sphere({.centre = {1.1, 0.2, 0}, .radius = 0.8, .edge_length = 0.1})};
  suture::TrackerOptions options;
  options.cell_size = 0.1;
  suture::Tracker tracker(suture::merged(spheres), options);
  const suture::SurgeryReport report = tracker.remodel();
  std::printf("%zu bodies before, %zu after\n", report.components_before, report.components_after);
  suture::write_triangles("out/union.ply", tracker.surface());
  return report.outcome == suture::Outcome::committed && report.components_after == 1 ? 0 : 1;
}
