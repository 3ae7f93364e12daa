// Multiplying by a power of two changes no digit, so results are those of the scene's own unit.
#include "surgery/model/unit.h"

#include <cmath>

#include "kernel/errors.h"
#include "kernel/lattice.h"
#include "surgery/model/option_table.h"
#include "surgery/model/tracker_lattice.h"

namespace suture::surgery {

namespace {

constexpr int kOrdinary = 64;       // cells of 2^±64: fourth powers of 2^-100 of a cell are normal
constexpr int kFarthestUnit = 200;  // between a cell and the edge length aimed at

bool exact(double x, int exponent) { return std::ldexp(std::ldexp(x, exponent), -exponent) == x; }

/// A length of an improvement that is not 0 stays so near the cells that both suit one unit.
void require_near(const OptionTable<QualityOptions>::Row& row, const TrackerOptions& o) {
  if (row.about.unit.length == 0) return;
  const double length = std::get<double>(*row.field.get(o.quality));
  const double farthest = std::ldexp(1.0, kFarthestUnit);
  if (length == 0 || (length / o.cell_size <= farthest && o.cell_size / length <= farthest)) return;
  throw InvalidInput("quality." + row.name + " is " + number(length) + " where cell_size is " +
                     number(o.cell_size) + "; keep the two within a factor of 2^" +
                     std::to_string(kFarthestUnit) + ", or leave it 0");
}

}  // namespace

int unit_exponent(const TrackerOptions& options) {
  const int exponent = std::ilogb(options.cell_size);
  return std::abs(exponent) <= kOrdinary ? 0 : exponent;
}

void require_unit(const TrackerOptions& o) {
  const double smallest = std::ldexp(1.0, kSmallestCell), largest = std::ldexp(1.0, kLargestCell);
  if (!(o.cell_size >= smallest && o.cell_size <= largest))
    throw InvalidInput("cell_size is " + number(o.cell_size) +
                       "; set it to a positive length from 2^" + std::to_string(kSmallestCell) +
                       " to 2^" + std::to_string(kLargestCell) + " (" + number(smallest) + " to " +
                       number(largest) + "), or scale the scene");
  for (const auto& row : quality_options().rows()) require_near(row, o);
  for (int a = 0; a < 3; ++a)
    if (!exact(o.origin[a], -unit_exponent(o)))
      throw InvalidInput("the lattice's origin has " + std::string(kAxisName[a]) + " = " +
                         number(o.origin[a]) + ", which doubles cannot hold beside cells of " +
                         number(o.cell_size) + "; set it to 0");
}

void require_room(const std::vector<Point>& positions, const TrackerOptions& options) {
  if (positions.empty()) return;
  if (const int unit = unit_exponent(options); unit > 0)
    for (std::size_t v = 0; v < positions.size(); ++v)
      for (int a = 0; a < 3; ++a)
        if (!exact(positions[v][a], -unit))
          throw InvalidInput("vertex " + std::to_string(v) + " has " + kAxisName[a] + " = " +
                             number(positions[v][a]) + ", which is too small beside cells of " +
                             number(options.cell_size) +
                             " to be kept in their unit; set it to 0, or choose smaller cells");
  tracker_lattice(positions, options);
}

TrackerOptions times_power(TrackerOptions options, int exponent) {
  scale_lengths(options, tracker_options(), exponent);
  scale_lengths(options.quality, quality_options(), exponent);
  return options;
}

bool multiply(Mesh& mesh, int exponent) {
  if (exponent == 0) return true;
  bool kept = true;
  for (const auto v : mesh.vertices()) {
    Point p = to_point(mesh.point(v));
    for (double& x : p) {
      kept &= exact(x, exponent);
      x = std::ldexp(x, exponent);
    }
    mesh.point(v) = to_cgal(p);
  }
  return kept;
}

bool multiply(Surface& surface, int exponent) {
  if (exponent == 0) return true;
  const bool kept = multiply(surface.mesh, exponent);
  for (Point& p : surface.triangles.positions)
    for (double& x : p) x = std::ldexp(x, exponent);
  return kept;
}

void multiply(SurgeryReport& report, int exponent) {
  for (VanishedBody& body : report.vanished) {
    body.volume = std::ldexp(body.volume, 3 * exponent);
    for (double& x : body.centre) x = std::ldexp(x, exponent);
  }
  report.volume_before = std::ldexp(report.volume_before, 3 * exponent);
  report.volume_after = std::ldexp(report.volume_after, 3 * exponent);
}

void multiply(QualityReport& report, int exponent) {
  report.shortest_edge = std::ldexp(report.shortest_edge, exponent);
  report.longest_edge = std::ldexp(report.longest_edge, exponent);
}

}  // namespace suture::surgery
