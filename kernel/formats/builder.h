// What every reader fills: vertices and polygons as the file gives them, checked at the end.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "kernel/triangles.h"

namespace suture {

/// Collects a polygon surface and turns it into triangles. `line` is where the element stood, or 0
/// in a binary file.
class SurfaceBuilder {
 public:
  /// `counts_from` is the number of the format's first vertex: messages count as the file does.
  explicit SurfaceBuilder(std::string file, std::int64_t counts_from = 0)
      : file_(std::move(file)), counts_from_(counts_from) {}

  void add_position(const Point& p, std::size_t line);
  /// Vertex indices from 0. \throw InvalidInput if there are fewer than three
  void add_face(std::span<const std::int64_t> corners, std::size_t line);

  std::size_t positions() const { return surface_.positions.size(); }

  /// Polygons are cut by `triangulate_polygon`. \throw InvalidInput if the mesh is empty, a
  /// coordinate is not finite or an index is out of range: with the count, and the line or element
  /// of the first
  Triangles finish() &&;

 private:
  void check_positions() const;
  void check_corners() const;
  std::string place(const char* element, std::size_t i, std::size_t line) const;

  std::string file_;
  std::int64_t counts_from_;
  Triangles surface_;
  std::vector<std::int64_t> corners_;
  std::vector<std::size_t> face_end_;
  std::vector<std::size_t> position_line_, face_line_;  // both empty for binary files
};

}  // namespace suture
