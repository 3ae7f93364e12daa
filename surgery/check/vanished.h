// The bodies that a surgery left nothing of, in a list for those who would miss them.
#pragma once

#include <cstdint>
#include <vector>

#include "kernel/triangles.h"
#include "surgery/model/report.h"

namespace suture::surgery {

/// A surface before surgery and after it, and each old vertex's new number, or kNone.
struct BeforeAndAfter {
  const Triangles &before, &after;
  const std::vector<std::uint32_t>& vertex_map;
};

/// Components of the old surface of which no vertex is left, and of whose volume nine tenths have
/// changed sides: they were thinner than a cell, or a gap as thin was filled. Bodies that merged
/// into others are not among them. It takes time only where a component has no vertex left.
std::vector<VanishedBody> vanished_bodies(const BeforeAndAfter& surgery);

}  // namespace suture::surgery
