// Building lattices, and refusing those that doubles or indices cannot hold.
#include "kernel/lattice.h"

#include <cmath>
#include <string>

#include "kernel/errors.h"

namespace suture {

namespace {

std::vector<double> planes_between(double low, double high, double cell, double origin, int margin,
                                   int axis) {
  const double first = std::floor((low - origin) / cell) - margin;
  const double last = std::ceil((high - origin) / cell) + margin;
  const double count = last - first + 1;
  if (!std::isfinite(count) || !std::isfinite(origin + last * cell))
    throw InvalidInput("a lattice of cells of " + number(cell) + " round " + kAxisName[axis] +
                       " = " + number(low) + " to " + number(high) +
                       " leaves the range of doubles; choose another cell, or scale the mesh");
  if (!(count <= kMaxPlanes))
    throw InvalidInput("cell size " + number(cell) + " asks for " + number(count - 1, "%.10g") +
                       " cells along " + kAxisName[axis] + ", at most " +
                       std::to_string(kMaxPlanes - 1) + " fit the indices; choose a larger cell");
  std::vector<double> planes(static_cast<std::size_t>(count));
  for (std::size_t i = 0; i < planes.size(); ++i)
    planes[i] = origin + (first + static_cast<double>(i)) * cell;
  bool apart = planes.size() > 1;
  for (std::size_t i = 1; i < planes.size(); ++i) apart &= planes[i - 1] < planes[i];
  if (!apart)
    throw InvalidInput(
        "cell size " + number(cell) + " is below the spacing of doubles near " + kAxisName[axis] +
        " = " + number(low) +
        "; choose a larger cell, an origin near the mesh, or move the mesh to the origin");
  return planes;
}

}  // namespace

Box bounding_box(const std::vector<Point>& positions) {
  Box box{positions.front(), positions.front()};
  for (const Point& p : positions) {
    box.low = box.low.cwiseMin(p);
    box.high = box.high.cwiseMax(p);
  }
  return box;
}

Lattice::Lattice(std::array<std::vector<double>, 3> planes) : planes_(std::move(planes)) {
  for (std::size_t a = 0; a < 3; ++a) {
    const auto& p = planes_[a];
    if (p.size() < 2 || p.size() > kMaxPlanes)
      throw InvalidInput(std::string("a lattice needs 2 to ") + std::to_string(kMaxPlanes) +
                         " planes along " + kAxisName[a] + ", not " + std::to_string(p.size()));
    for (std::size_t i = 0; i < p.size(); ++i)
      if (!std::isfinite(p[i]) || (i > 0 && !(p[i - 1] < p[i])))
        throw InvalidInput(std::string("lattice planes along ") + kAxisName[a] +
                           " must be finite and increase; plane " + std::to_string(i) +
                           " does not");
    per_unit_[a] = static_cast<double>(p.size() - 1) / (p.back() - p.front());
  }
}

Lattice lattice_around(const Box& box, double cell_size, const Point& origin, int margin) {
  if (!(std::isfinite(cell_size) && cell_size > 0))
    throw InvalidInput("cell size is " + number(cell_size) +
                       "; it must be a finite positive length");
  if (!box.low.allFinite() || !box.high.allFinite() || !origin.allFinite())
    throw InvalidInput("a lattice needs finite coordinates and a finite origin");
  std::array<std::vector<double>, 3> planes;
  for (int a = 0; a < 3; ++a)
    planes[static_cast<std::size_t>(a)] =
        planes_between(box.low[a], box.high[a], cell_size, origin[a], margin, a);
  return Lattice(std::move(planes));
}

}  // namespace suture
