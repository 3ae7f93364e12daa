// Crossings sorted along their lattice lines and summed up.
#include "surgery/detect/winding.h"

#include <algorithm>

#include "kernel/errors.h"

namespace suture::surgery {

namespace {

/// Sorts like (line, position along it): the index along `axis` moved to the lowest bits.
LatticeId line_key(int axis, const Index3& at) {
  return pack(at[next_axis(axis)], at[prev_axis(axis)], at[axis]);
}
constexpr LatticeId kAlong = (LatticeId{1} << kIndexBits) - 1;

}  // namespace

Winding::Winding(const Crossings& crossings) {
  std::array<std::vector<std::pair<LatticeId, std::uint32_t>>, 3> keyed;
  for (std::uint32_t c = 0; c < crossings.line_crossings.size(); ++c) {
    const LineCrossing& x = crossings.line_crossings[c];
    keyed[x.axis].emplace_back(line_key(x.axis, unpack(x.edge)), c);
  }
  for (int axis = 0; axis < 3; ++axis) {
    auto& keys = keyed[axis];
    std::sort(keys.begin(), keys.end());
    Lines& lines = lines_[axis];
    lines.order.reserve(keys.size());
    LatticeId line = ~LatticeId{0};
    int winding = 0;
    for (std::size_t i = 0; i < keys.size();) {
      const LatticeId key = keys[i].first;
      if ((key & ~kAlong) != line) {
        if (winding != 0)
          throw InternalFailure("winding", "a lattice line leaves a closed mesh inside");
        line = key & ~kAlong;
      }
      const auto first = static_cast<std::uint32_t>(i);
      const int before = winding;
      for (; i < keys.size() && keys[i].first == key; ++i) {
        winding += crossings.line_crossings[keys[i].second].delta;
        lines.order.push_back(keys[i].second);
      }
      const auto at = static_cast<std::uint32_t>(lines.edges.size());
      Range& range = lines.line[line];
      if (range.end == 0) range.begin = at;
      range.end = at + 1;
      lines.edges.push_back({crossings.line_crossings[keys[first].second].edge, before, winding,
                             first, static_cast<std::uint32_t>(i) - first});
    }
    if (winding != 0)
      throw InternalFailure("winding", "a lattice line leaves a closed mesh inside");
  }
}

const CrossedEdge* Winding::last_up_to(int axis, const Index3& at) const {
  const Lines& lines = lines_[axis];
  const Range* range = lines.line.find(line_key(axis, at) & ~kAlong);
  if (!range) return nullptr;
  const auto begin = lines.edges.begin() + range->begin, end = lines.edges.begin() + range->end;
  const auto past = std::upper_bound(begin, end, at[axis], [axis](int k, const CrossedEdge& e) {
    return k < unpack(e.edge)[axis];
  });
  return past == begin ? nullptr : &*(past - 1);
}

int Winding::at(const Index3& node, int axis) const {
  const CrossedEdge* e = last_up_to(axis, node);
  if (!e) return 0;
  return unpack(e->edge)[axis] == node[axis] ? e->before : e->after;
}

const CrossedEdge* Winding::edge(int axis, const Index3& at) const {
  const CrossedEdge* e = last_up_to(axis, at);
  return e && e->edge == pack(at) ? e : nullptr;
}

bool marches_agree(const Winding& winding) {
  for (int axis = 0; axis < 3; ++axis)
    for (const CrossedEdge& e : winding.edges(axis)) {
      const Index3 low = unpack(e.edge), high = unpack(step(e.edge, axis, 1));
      for (int other = 0; other < 3; ++other)
        if (winding.at(low, other) != e.before || winding.at(high, other) != e.after) return false;
    }
  return true;
}

}  // namespace suture::surgery
