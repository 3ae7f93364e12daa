// Each generator is a few lines over the kernel's shapes and tubes; sizes are drawn, counts small.
#include "sims/fuzz/generators.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "kernel/errors.h"
#include "kernel/shapes/shapes.h"
#include "kernel/shapes/transform.h"
#include "sims/fuzz/extrude.h"
#include "sims/support/keys.h"

namespace suture::sims {

namespace {

using Input = GeneratorInput;

constexpr double kTurn = 2 * std::numbers::pi;

Point vector_in(Random& random, double reach) {
  return {random.uniform(-reach, reach), random.uniform(-reach, reach),
          random.uniform(-reach, reach)};
}

Triangles turned(Triangles body, const Draws& d) {
  return rotated(std::move(body), d.vector("axis", 1) + Point(0, 0, 1.5),
                 d.uniform("angle", 0, kTurn));
}

/// The body moved near the others; in a third of the cases by whole cells.
Triangles placed(Triangles body, const Input& in, double reach = 0.8) {
  Point by = in.draws.vector("place", reach);
  if (in.draws.once_in("place in whole cells", 3))
    for (int a = 0; a < 3; ++a) by[a] = in.cell * std::round(by[a] / in.cell);
  return translated(std::move(body), by);
}

Triangles inverted(Triangles body) {
  for (Triangle& t : body.triangles) std::swap(t[1], t[2]);
  return body;
}

Triangles blob(const Input& in) {
  const Draws& d = in.draws;
  Triangles body = sphere({Point::Zero(), d.uniform("radius", 0.2, 0.9), 0.1,
                           in.large() ? d.whole("large rings", 4, 8) : d.whole("rings", 1, 2)});
  const double bumps = d.once_in("smooth", 2) ? 0 : d.uniform("bumps", 0, 0.5);
  Random random = d.of("bump");
  for (Point& p : body.positions) p *= 1 + random.uniform(-bumps, bumps);
  return body;
}

Triangles blobs(const Input& in) {
  std::vector<Triangles> bodies;
  const Draws& d = in.draws;
  const int count = in.large() ? d.whole("large count", 2, 12) : d.whole("count", 2, 4);
  for (int b = 0; b < count; ++b) {
    const Input body = in.in("body", b);
    bodies.push_back(placed(blob(body), body));
  }
  return merged(bodies);
}

std::vector<Point> circle(double radius, int points) {
  std::vector<Point> line;
  for (int k = 0; k < points; ++k)
    line.push_back(radius * Point(std::cos(kTurn * k / points), std::sin(kTurn * k / points), 0));
  return line;
}

Triangles torus(const Input& in) {
  const Draws& d = in.draws;
  const double radius = d.uniform("radius", 0.3, 0.9);
  const int points = in.large() ? d.whole("large points", 20, 60) : d.whole("points", 4, 12);
  const int sides = in.large() ? 16 : d.whole("sides", 3, 6);
  return tube(circle(radius, points),
              {d.uniform("thickness", 0.03, 0.9) * radius, sides, Ends::joined});
}

Triangles tori(const Input& in) {
  std::vector<Triangles> bodies;
  for (int b = 0, count = in.draws.whole("count", 1, 3); b < count; ++b) {
    const Input body = in.in("body", b);
    bodies.push_back(placed(turned(torus(body), body.draws), body, 0.5));
  }
  return merged(bodies);
}

Triangles sheets(const Input& in) {
  std::vector<Triangles> bodies;
  const double thickness = 0.37 * in.draws.uniform("thickness", 0.005, 1);  // 300° allow 0.38
  for (int b = 0, count = in.draws.whole("count", 1, 3); b < count; ++b) {
    const Input body = in.in("body", b);
    const Draws& d = body.draws;
    const double degrees = d.once_in("flat", 2) ? 0 : d.uniform("degrees", -300, 300);
    bodies.push_back(placed(turned(sheet({Point::Zero(), 2, d.uniform("width", 0.4, 1.5), thickness,
                                          degrees, in.large() ? 0.08 : 0.5}),
                                   d),
                            body, 0.4));
  }
  return merged(bodies);
}

/// A strip rolled past a full turn, often thicker than the space between its turns.
Triangles roll(const Input& in) {
  const Draws& d = in.draws;
  const double turns = d.uniform("turns", 1.05, 3), pitch = d.uniform("pitch", -0.2, 0.3);
  const double half = 0.5 * d.uniform("thickness", 0.02, 0.4);
  const Point up(0, 0, d.uniform("width", 0.1, 0.8));
  const int points = static_cast<int>(turns * (in.large() ? 60 : d.whole("points", 6, 12))) + 2;
  std::vector<std::vector<Point>> stations;
  for (int s = 0; s < points; ++s) {
    const double angle = kTurn * turns * s / (points - 1), r = 0.7 + pitch * angle / kTurn;
    const Point out(std::cos(angle), std::sin(angle), 0);
    stations.push_back({(r - half) * out - up, (r - half) * out + up, (r + half) * out + up,
                        (r + half) * out - up});
  }
  return turned(extrude(stations, Ends::capped), d);
}

Triangles tangle(const Input& in) {
  std::vector<Triangles> bodies;
  for (int b = 0, count = in.draws.whole("count", 1, 3); b < count; ++b) {
    const Draws d = in.draws.in("body", static_cast<std::uint64_t>(b));
    std::vector<Point> line{d.vector("start", 0.8)};
    Random step = d.of("step");
    for (int k = in.large() ? d.whole("large steps", 30, 120) : d.whole("steps", 3, 14); k > 0; --k)
      line.push_back(0.9 * line.back() + vector_in(step, 0.7));
    const Ends ends = line.size() > 3 && d.once_in("ring", 2) ? Ends::joined : Ends::capped;
    bodies.push_back(tube(line, {d.uniform("radius", 0.02, 0.35), d.whole("sides", 3, 6), ends}));
  }
  return merged(bodies);
}

/// Any closed surface with its vertices thrown anywhere.
Triangles soup(const Input& in) {
  const Draws& d = in.draws;
  Triangles body = d.once_in("one blob", 2) ? blob(in.in("blob")) : tori(in.in("tori"));
  const double share = d.uniform("share", 0.05, 1), reach = d.uniform("reach", 0.3, 1.2);
  Random random = d.of("throw");
  for (Point& p : body.positions)
    if (random.uniform() < share) p = vector_in(random, reach);
  return body;
}

Triangles carved(const Input& in) {
  const Draws& d = in.draws;
  Triangles body = carved_ball({Point::Zero(), d.uniform("radius", 0.5, 0.9),
                                d.uniform("depth", 0.2, 0.6), d.uniform("groove width", 0.05, 0.15),
                                d.whole("seed", 1, 1000), in.large() ? 0.08 : 0.35});
  return placed(std::move(body), in, 0.3);
}

Triangles dumbbells(const Input& in) {
  const Draws& d = in.draws;
  const double radius = d.uniform("radius", 0.25, 0.5),
               neck = d.uniform("neck", 0.02, 0.6) * radius;
  if (in.large())
    return turned(dumbbell({Point::Zero(), radius, 3 * radius, neck, 0.2 * radius, 0.15}), d);
  std::vector<std::vector<Point>> stations;
  const int sides = d.whole("sides", 3, 7), rows = d.whole("rows", 6, 12);
  for (int s = 0; s <= rows; ++s) {
    const double z = 2.0 * s / rows - 1;
    const double r = neck + (radius - neck) * std::pow(std::sin(std::numbers::pi * z), 2);
    auto& station = stations.emplace_back();
    for (const Point& p : circle(r, sides)) station.push_back(p + Point(0, 0, z));
  }
  return turned(extrude(stations, Ends::capped), d);
}

/// Boxes on the lattice's planes or between them, beside, on and in one another.
Triangles boxes(const Input& in) {
  std::vector<Triangles> bodies;
  for (int b = 0, count = in.draws.whole("count", 1, 4); b < count; ++b) {
    const Draws d = in.draws.in("body", static_cast<std::uint64_t>(b));
    const double unit = d.once_in("half cells", 3) ? in.cell / 2 : in.cell;
    const auto most = static_cast<std::uint64_t>(std::max(1.0, 1.2 / unit));
    Random sizes = d.of("sizes"), corner = d.of("corner");
    Point size, low;
    for (int a = 0; a < 3; ++a) {
      size[a] = unit * static_cast<double>(1 + sizes.below(most));
      low[a] = unit * std::round(corner.uniform(-0.8, 0.8) / unit);
    }
    bodies.push_back(
        box({low + size / 2, size, in.large() ? 0.15 : d.uniform("edge length", 0.5, 2)}));
  }
  return merged(bodies);
}

/// A body in a cavity of a body in a cavity; now and then a shell that is not inside anything.
Triangles nested(const Input& in) {
  std::vector<Triangles> bodies;
  double scale = 1;
  const Triangles first = in.draws.once_in("box", 2) ? box({Point::Zero(), Point::Constant(1.4), 1})
                                                     : blob(in.in("blob"));
  for (int b = 0, count = in.draws.whole("count", 2, 5); b < count; ++b) {
    const Input body = in.in("shell", b);
    const Draws& d = body.draws;
    Triangles shell = scaled(first, scale);
    if (d.once_in("placed", 4)) shell = placed(std::move(shell), body, 0.4);
    const bool cavity = b % 2 == 1 || d.once_in("inverted", 8);
    bodies.push_back(cavity ? inverted(std::move(shell)) : std::move(shell));
    scale *= d.once_in("the next as large", 5) ? 1 : d.uniform("scale of the next", 0.4, 0.98);
  }
  return merged(bodies);
}

/// Thin needles over many cells, oblique to every axis.
Triangles needles(const Input& in) {
  std::vector<Triangles> bodies;
  const double thin = std::ldexp(1.0, -in.draws.whole("thin", 3, 40));
  for (int b = 0, count = in.draws.whole("count", 1, 4); b < count; ++b) {
    const Draws d = in.draws.in("needle", static_cast<std::uint64_t>(b));
    const Point from = d.vector("from", 1.2);
    Point to = d.vector("to", 1.2);
    if (d.once_in("nearly upright", 4)) to = from + Point(0, 0, 1) + d.vector("off", 0x1p-20);
    bodies.push_back(tube({from, to}, {thin, d.whole("sides", 3, 4), Ends::capped}));
  }
  const Input body = in.in("blob");
  bodies.push_back(placed(blob(body), body, 0.3));
  return merged(bodies);
}

/// Bodies and exact copies of them; cavities, inversions and zeros with a sign tell some apart.
Triangles copies(const Input& in) {
  const Input original = in.in("original"), other = in.in("other");
  const Triangles body =
      placed(in.draws.once_in("of a blob", 2) ? blob(original) : boxes(original), original, 0.4);
  std::vector<Triangles> bodies{body};
  for (int b = 0, count = in.draws.whole("count", 1, 3); b < count; ++b) {
    const Input copied = in.in("copy", b);
    const Draws& d = copied.draws;
    Triangles copy = body;
    if (d.once_in("inverted", 4)) copy = inverted(std::move(copy));
    if (d.once_in("scaled", 4)) copy = scaled(std::move(copy), d.uniform("scale", 0.5, 1));
    if (d.once_in("one bit off", 4))
      copy.positions[0][0] = std::nextafter(copy.positions[0][0], 9.0);
    if (d.once_in("placed", 4)) copy = placed(std::move(copy), copied, in.cell);
    bodies.push_back(std::move(copy));
  }
  if (in.draws.once_in("another body", 2)) bodies.push_back(placed(blob(other), other));
  return merged(bodies);
}

/// A tetrahedron whose fourth corner is in the plane of the others, or next to it.
Triangles sliver(const Draws& d) {
  Triangles body{{d.vector("a", 1), d.vector("b", 1), d.vector("c", 1), {}},
                 {{0, 1, 2}, {1, 0, 3}, {2, 1, 3}, {0, 2, 3}}};
  const double u = d.uniform("u", -0.2, 1.2);
  const double v = d.once_in("on a line", 2) ? 0 : d.uniform("v", -0.2, 1);
  body.positions[3] = body.positions[0] + u * (body.positions[1] - body.positions[0]) +
                      v * (body.positions[2] - body.positions[0]);
  if (d.once_in("off the plane", 3)) body.positions[3] += d.vector("off", 0x1p-30);
  return body;
}

/// Some triangle becomes three, about a new vertex on one of its edges or inside it.
void split_triangle(Triangles& body, const Draws& d) {
  const Triangle t = body.triangles[d.of("triangle").below(body.triangles.size())];
  const Point &a = body.positions[t[0]], &b = body.positions[t[1]], &c = body.positions[t[2]];
  const double u = d.uniform("u", 0, 1);
  const double v = d.once_in("on an edge", 2) ? 0 : (1 - u) * d.uniform("v", 0, 1);
  const auto m = static_cast<std::uint32_t>(body.positions.size());
  body.positions.push_back(Point(a + u * (b - a) + v * (c - a)));
  for (Triangle& old : body.triangles)
    if (old == t) old = {t[0], t[1], m};
  body.triangles.push_back({t[1], t[2], m});
  body.triangles.push_back({t[2], t[0], m});
}

/// Flat tetrahedra and split triangles: no area, no volume, collinear corners.
Triangles slivers(const Input& in) {
  std::vector<Triangles> bodies;
  for (int b = 0, count = in.draws.whole("count", 2, 8); b < count; ++b)
    bodies.push_back(sliver(in.in("sliver", b).draws));
  const Input main = in.in("blob");
  Triangles body = placed(blob(main), main, 0.3);
  for (int k = 0, count = in.draws.whole("splits", 0, 6); k < count; ++k)
    split_triangle(body, in.in("split", k).draws);
  bodies.push_back(std::move(body));
  return merged(bodies);
}

}  // namespace

GeneratorInput GeneratorInput::in(const char* part, int index) const {
  return {draws.in(part, static_cast<std::uint64_t>(index)), cell, size};
}

const std::vector<Generator>& generators() {
  static const std::vector<Generator> all = {
      {"blobs", blobs},     {"boxes", boxes},         {"carved", carved},
      {"copies", copies},   {"dumbbells", dumbbells}, {"needles", needles},
      {"nested", nested},   {"roll", roll},           {"sheets", sheets},
      {"slivers", slivers}, {"soup", soup},           {"tangle", tangle},
      {"tori", tori}};
  return all;
}

const Generator& generator_named(const std::string& name, const std::vector<Generator>& known) {
  std::vector<std::string> names;
  for (const Generator& generator : known) {
    if (generator.name == name) return generator;
    names.push_back(generator.name);
  }
  throw InvalidInput("there is no generator \"" + name + "\"; there are " + joined(names));
}

}  // namespace suture::sims
