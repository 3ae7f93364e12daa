// The surface that every reader fills with a file's vertices and polygons, checked at the end.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "kernel/triangles.h"

namespace suture {

/// Collects a polygon surface and turns it into triangles. `line` is the line on which the element
/// stands, counted from 1, or 0 in a binary file.
class SurfaceBuilder {
 public:
  /// `file` stands for the file in messages, and `counts_from` is the number that its format gives
  /// the first vertex: messages count as the file does.
  explicit SurfaceBuilder(std::string file, std::int64_t counts_from = 0)
      : file_(std::move(file)), counts_from_(counts_from) {}

  void add_position(const Point& p, std::size_t line);
  /// Adds a face by its vertex indices, which count from 0. \throw InvalidInput if there are fewer
  /// than three
  void add_face(std::span<const std::int64_t> corners, std::size_t line);

  std::size_t positions() const { return surface_.positions.size(); }

  /// Returns the surface, its polygons cut by `triangulate_polygon`. \throw InvalidInput if the
  /// mesh is empty, a coordinate is not finite or an index is out of range; the message gives their
  /// count and the line or element of the first
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
