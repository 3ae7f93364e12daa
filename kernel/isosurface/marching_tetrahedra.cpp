// Marching tetrahedra, cube by cube, on values at nodes: closed, manifold, embedded [Kuhn 1960].
#include "kernel/isosurface/marching_tetrahedra.h"

#include <algorithm>

namespace suture {

namespace {

// Each tetrahedron goes from corner 0 to 7 in three axis steps; swapped where needed so that all
// are right-handed.
constexpr std::array<std::array<int, 4>, 6> kTetrahedra{
    {{0, 1, 3, 7}, {0, 3, 2, 7}, {0, 2, 6, 7}, {0, 6, 4, 7}, {0, 4, 5, 7}, {0, 5, 1, 7}}};

}  // namespace

void MarchingTetrahedra::add_cube(const Corners& corners) {
  int inside = 0;
  for (const CubeCorner& c : corners) inside += c.value < 0;
  if (inside == 0 || inside == 8) return;
  for (const auto& t : kTetrahedra) add_tetrahedron(corners, t);
}

// Corners are put in an even permutation that brings those inside to the front.
void MarchingTetrahedra::add_tetrahedron(const Corners& corners, std::array<int, 4> t) {
  std::array<int, 4> in{};
  for (int k = 0; k < 4; ++k) in[k] = corners[t[k]].value < 0;
  const int count = in[0] + in[1] + in[2] + in[3];
  if (count == 0 || count == 4) return;
  int swaps = 0;
  for (int k = 0, front = 0; k < 4; ++k)
    if (in[k]) {
      if (k != front) {
        std::swap(t[k], t[front]);
        std::swap(in[k], in[front]);
        ++swaps;
      }
      ++front;
    }
  if (swaps % 2 == 1) count == 1 ? std::swap(t[2], t[3]) : std::swap(t[0], t[1]);
  const auto v = [&](int a, int b) { return vertex(corners, t[a], t[b]); };
  if (count == 1) {
    surface_.triangles.push_back({v(0, 1), v(0, 2), v(0, 3)});
  } else if (count == 3) {
    surface_.triangles.push_back({v(3, 0), v(3, 1), v(3, 2)});
  } else {
    surface_.triangles.push_back({v(0, 2), v(0, 3), v(1, 3)});
    surface_.triangles.push_back({v(0, 2), v(1, 3), v(1, 2)});
  }
}

std::uint32_t MarchingTetrahedra::vertex(const Corners& corners, int a, int b) {
  if (a > b) std::swap(a, b);  // then b − a, as bits, is the edge's direction
  const CubeCorner &from = corners[a], &to = corners[b];
  const std::size_t known = at_.size(), at = at_.index(8 * from.id + (b - a));
  if (at == known) surface_.positions.push_back(place_(from, to));
  return static_cast<std::uint32_t>(at);
}

double linear_zero(double from, double to, double off_ends) {
  return std::clamp(from / (from - to), off_ends, 1 - off_ends);
}

}  // namespace suture
