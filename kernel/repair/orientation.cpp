// Consistent orientation, by walking over edges that exactly two triangles share.
#include "kernel/repair/orientation.h"

#include <algorithm>

#include "kernel/corners.h"

namespace suture {

namespace {

// The triangle across an edge of just two, and whether both run along it the same way.
struct Across {
  std::uint32_t triangle;
  bool opposed;
};

// The triangles of a surface and their neighbours.
struct Neighbourhood {
  explicit Neighbourhood(const Triangles& s) : surface(s), corners(s) {}

  // The other triangle at edge k of triangle t; kNone at a border and where three or more share it.
  Across across(std::uint32_t t, std::size_t k) const {
    Across found{kNone, false};
    bool single = true;
    const Triangle& at = surface.triangles[t];
    corners.for_each_use(at[k], at[(k + 1) % 3], [&](std::uint32_t other, bool same_way) {
      if (other == t) return;
      single &= found.triangle == kNone;
      found = {other, same_way};
    });
    return single ? found : Across{kNone, false};
  }

  const Triangles& surface;
  Corners corners;
};

// One component.
struct Walk {
  std::vector<std::uint32_t> members;
  std::size_t turned = 0;
  bool orientable = true;
};

// Walks through the component of `start` and decides for each member whether to turn it.
Walk walk(const Neighbourhood& all, std::uint32_t start, std::vector<std::int8_t>& turn) {
  Walk result;
  result.members.push_back(start);
  turn[start] = 0;
  for (std::size_t i = 0; i < result.members.size(); ++i) {
    const std::uint32_t t = result.members[i];
    result.turned += turn[t] == 1 ? 1 : 0;
    for (std::size_t k = 0; k < 3; ++k) {
      const Across next = all.across(t, k);
      if (next.triangle == kNone) continue;
      const auto wanted = static_cast<std::int8_t>(next.opposed ? 1 - turn[t] : turn[t]);
      if (turn[next.triangle] < 0) {
        turn[next.triangle] = wanted;
        result.members.push_back(next.triangle);
      } else if (turn[next.triangle] != wanted) {
        result.orientable = false;
      }
    }
  }
  return result;
}

}  // namespace

TurnedTriangles orient_consistently(Triangles& surface) {
  const Neighbourhood all(surface);
  std::vector<std::int8_t> turn(surface.triangles.size(), -1);  // -1 until it is met
  TurnedTriangles result;
  for (std::size_t i = 0; i < turn.size(); ++i) {
    if (turn[i] >= 0 || !usable(surface.triangles[i], surface.positions.size())) continue;
    const Walk walked = walk(all, static_cast<std::uint32_t>(i), turn);
    if (!walked.orientable) {
      ++result.not_orientable;
      for (const std::uint32_t t : walked.members) turn[t] = 0;
      continue;
    }
    const bool fewer_are_others = 2 * walked.turned > walked.members.size();
    for (const std::uint32_t t : walked.members)
      if (fewer_are_others) turn[t] = static_cast<std::int8_t>(1 - turn[t]);
    result.triangles += fewer_are_others ? walked.members.size() - walked.turned : walked.turned;
  }
  for (std::size_t i = 0; i < turn.size(); ++i)
    if (turn[i] == 1) std::swap(surface.triangles[i][1], surface.triangles[i][2]);
  return result;
}

}  // namespace suture
