// Polygons become triangles here, and the faults that every format can have are found.
#include "kernel/formats/builder.h"

#include "kernel/errors.h"
#include "kernel/formats/polygon.h"

namespace suture {

void SurfaceBuilder::add_position(const Point& p, std::size_t line) {
  surface_.positions.push_back(p);
  if (line > 0) position_line_.push_back(line);
}

void SurfaceBuilder::add_face(std::span<const std::int64_t> corners, std::size_t line) {
  if (corners.size() < 3)
    throw InvalidInput(place("face", face_end_.size(), line) + " has " +
                       std::to_string(corners.size()) +
                       " vertices; a face needs three or more: export the mesh again");
  corners_.insert(corners_.end(), corners.begin(), corners.end());
  face_end_.push_back(corners_.size());
  if (line > 0) face_line_.push_back(line);
}

std::string SurfaceBuilder::place(const char* element, std::size_t i, std::size_t line) const {
  return file_ + (line > 0 ? ":" + std::to_string(line) : "") + ": " + element + " " +
         std::to_string(static_cast<std::int64_t>(i) + counts_from_);
}

void SurfaceBuilder::check_positions() const {
  if (positions() >= kNone)
    throw InvalidInput(file_ + ": the mesh has " + std::to_string(positions()) +
                       " vertices, more than indices of 32 bits can name; split the mesh");
  std::size_t count = 0, first = 0;
  for (std::size_t i = positions(); i-- > 0;)
    if (!surface_.positions[i].allFinite()) {
      ++count;
      first = i;
    }
  if (count > 0)
    throw InvalidInput(place("vertex", first, position_line_.empty() ? 0 : position_line_[first]) +
                       " has a coordinate that is not finite (" + std::to_string(count) +
                       " such in all); export the mesh again without NaN or infinity");
}

void SurfaceBuilder::check_corners() const {
  std::size_t count = 0, first = 0;
  const auto end = static_cast<std::int64_t>(positions());
  for (std::size_t i = corners_.size(); i-- > 0;)
    if (corners_[i] < 0 || corners_[i] >= end) {
      ++count;
      first = i;
    }
  if (count == 0) return;
  std::size_t face = 0;
  while (face_end_[face] <= first) ++face;
  throw InvalidInput(place("face", face, face_line_.empty() ? 0 : face_line_[face]) +
                     " has the vertex index " + std::to_string(corners_[first] + counts_from_) +
                     ", counted from " + std::to_string(counts_from_) + ", but there are " +
                     std::to_string(positions()) + " vertices (" + std::to_string(count) +
                     " such in all); the file is incomplete or damaged: export it again");
}

Triangles SurfaceBuilder::finish() && {
  if (positions() == 0 || face_end_.empty())
    throw InvalidInput(file_ + ": the mesh is empty: " + std::to_string(positions()) +
                       " vertices, " + std::to_string(face_end_.size()) +
                       " faces; give a mesh with at least one triangle");
  check_positions();
  check_corners();
  surface_.triangles.reserve(corners_.size() - 2 * face_end_.size());
  std::size_t begin = 0;
  for (const std::size_t end : face_end_) {
    triangulate_polygon(surface_.positions, {corners_.data() + begin, end - begin},
                        surface_.triangles);
    begin = end;
  }
  return std::move(surface_);
}

}  // namespace suture
