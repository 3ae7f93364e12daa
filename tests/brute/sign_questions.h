// What an oracle can be asked, drawn near degeneracy: one question, to be put to several oracles.
#pragma once

#include <array>
#include <cstdio>
#include <string>

#include "predicates/oracle.h"
#include "tests/brute/near_degenerate.h"

namespace suture::brute {

enum class Decision { edge_side, triangle_side, orientation };
inline constexpr std::array kDecisions = {Decision::edge_side, Decision::triangle_side,
                                          Decision::orientation};

inline const char* name_of(Decision decision) {
  constexpr const char* kNames[] = {"edge_side", "triangle_side", "orientation"};
  return kNames[static_cast<int>(decision)];
}

struct SignQuestion {
  Decision decision;
  Points4 points;
  LatticePoint2 at;  ///< of edge_side, which asks about the first two points
};

inline LatticePoint2 lattice_point(const Point& at, Draws& random) {
  const int u = random.below(3), v = (u + random.between(1, 2)) % 3;
  return {u, v, at[u], at[v]};
}

inline SignQuestion sign_question(Decision decision, Family family, Draws& random) {
  const Points4 points = near_degenerate(family, random);
  return {decision, points, lattice_point(points[2], random)};
}

inline int ask(const Oracle& oracle, const SignQuestion& question) {
  const Points4& p = question.points;
  switch (question.decision) {
    case Decision::edge_side:
      return oracle.edge_side(p[0], p[1], question.at);
    case Decision::triangle_side:
      return oracle.triangle_side(p[0], p[1], p[2], p[3]);
    case Decision::orientation:
      break;
  }
  return oracle.orientation(p[0], p[1], p[2], p[3]);
}

/// Writes x to the last bit, and such that C++ reads it back.
inline std::string show(double x) {
  char text[40];
  std::snprintf(text, sizeof text, "%a ", x);
  return text;
}

inline std::string show(const Point& p) { return show(p[0]) + show(p[1]) + show(p[2]); }

inline std::string show(const Points4& points) {
  return show(points[0]) + show(points[1]) + show(points[2]) + show(points[3]);
}

inline std::string show(const SignQuestion& question) {
  std::string text = name_of(question.decision) + (": " + show(question.points));
  if (question.decision == Decision::edge_side)
    text += "axes " + std::to_string(question.at.u_axis) + std::to_string(question.at.v_axis);
  return text;
}

}  // namespace suture::brute
