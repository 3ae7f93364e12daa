// Each generator is a few lines over the kernel's shapes and tubes; sizes are drawn, counts small.
#include "sims/fuzz/generators.h"

#include <array>
#include <cmath>
#include <numbers>

#include "kernel/errors.h"
#include "kernel/measure/measures.h"
#include "kernel/shapes/shapes.h"
#include "kernel/shapes/transform.h"
#include "sims/fuzz/extrude.h"
#include "sims/support/keys.h"

namespace suture::sims {

namespace {

constexpr double kTurn = 2 * std::numbers::pi;

Point vector_in(Random& random, double reach) {
  return {random.uniform(-reach, reach), random.uniform(-reach, reach),
          random.uniform(-reach, reach)};
}

int count(Draw& d, int least, int most) {
  return least + static_cast<int>(d.random.below(static_cast<std::uint64_t>(most - least + 1)));
}

bool one_in(Draw& d, std::uint64_t n) { return d.random.below(n) == 0; }

Triangles turned(Triangles body, Draw& d) {
  return rotated(std::move(body), vector_in(d.random, 1) + Point(0, 0, 1.5),
                 d.random.uniform(0, kTurn));
}

/// Near the others; in a third of the cases by whole cells.
Triangles placed(Triangles body, Draw& d, double reach = 0.8) {
  Point by = vector_in(d.random, reach);
  if (one_in(d, 3))
    for (int a = 0; a < 3; ++a) by[a] = d.cell * std::round(by[a] / d.cell);
  return translated(std::move(body), by);
}

Triangles inverted(Triangles body) {
  for (Triangle& t : body.triangles) std::swap(t[1], t[2]);
  return body;
}

Triangles blob(Draw& d) {
  Triangles body = sphere(
      {Point::Zero(), d.random.uniform(0.2, 0.9), 0.1, d.large ? count(d, 4, 8) : count(d, 1, 2)});
  const double bumps = one_in(d, 2) ? 0 : d.random.uniform(0, 0.5);
  for (Point& p : body.positions) p *= 1 + d.random.uniform(-bumps, bumps);
  return body;
}

Triangles blobs(Draw& d) {
  std::vector<Triangles> bodies;
  for (int b = count(d, 2, d.large ? 12 : 4); b > 0; --b) bodies.push_back(placed(blob(d), d));
  return merged(bodies);
}

std::vector<Point> circle(double radius, int points) {
  std::vector<Point> line;
  for (int k = 0; k < points; ++k)
    line.push_back(radius * Point(std::cos(kTurn * k / points), std::sin(kTurn * k / points), 0));
  return line;
}

Triangles tori(Draw& d) {
  std::vector<Triangles> bodies;
  for (int b = count(d, 1, 3); b > 0; --b) {
    const double radius = d.random.uniform(0.3, 0.9);
    const int points = d.large ? count(d, 20, 60) : count(d, 4, 12);
    bodies.push_back(
        placed(turned(tube(circle(radius, points), {d.random.uniform(0.03, 0.9) * radius,
                                                    d.large ? 16 : count(d, 3, 6), Ends::joined}),
                      d),
               d, 0.5));
  }
  return merged(bodies);
}

Triangles sheets(Draw& d) {
  std::vector<Triangles> bodies;
  const double thickness = 0.37 * d.random.uniform(0.005, 1);  // 300° allow 0.38
  for (int b = count(d, 1, 3); b > 0; --b)
    bodies.push_back(
        placed(turned(sheet({Point::Zero(), 2, d.random.uniform(0.4, 1.5), thickness,
                             one_in(d, 2) ? 0 : d.random.uniform(-300, 300), d.large ? 0.08 : 0.5}),
                      d),
               d, 0.4));
  return merged(bodies);
}

/// A strip rolled past a full turn, often thicker than the space between its turns.
Triangles roll(Draw& d) {
  const double turns = d.random.uniform(1.05, 3), pitch = d.random.uniform(-0.2, 0.3);
  const double half = 0.5 * d.random.uniform(0.02, 0.4), width = d.random.uniform(0.1, 0.8);
  const int points = static_cast<int>(turns * (d.large ? 60 : count(d, 6, 12))) + 2;
  std::vector<std::vector<Point>> stations;
  for (int s = 0; s < points; ++s) {
    const double angle = kTurn * turns * s / (points - 1), r = 0.7 + pitch * angle / kTurn;
    const Point out(std::cos(angle), std::sin(angle), 0);
    const Point up(0, 0, width);
    stations.push_back({(r - half) * out - up, (r - half) * out + up, (r + half) * out + up,
                        (r + half) * out - up});
  }
  return turned(sweep(stations, Ends::capped), d);
}

Triangles tangle(Draw& d) {
  std::vector<Triangles> bodies;
  for (int b = count(d, 1, 3); b > 0; --b) {
    std::vector<Point> line{vector_in(d.random, 0.8)};
    for (int k = d.large ? count(d, 30, 120) : count(d, 3, 14); k > 0; --k)
      line.push_back(0.9 * line.back() + vector_in(d.random, 0.7));
    const Ends ends = line.size() > 3 && one_in(d, 2) ? Ends::joined : Ends::capped;
    bodies.push_back(tube(line, {d.random.uniform(0.02, 0.35), count(d, 3, 6), ends}));
  }
  return merged(bodies);
}

/// Any closed surface with its vertices thrown anywhere.
Triangles soup(Draw& d) {
  Triangles body = one_in(d, 2) ? blob(d) : tori(d);
  const double share = d.random.uniform(0.05, 1), reach = d.random.uniform(0.3, 1.2);
  for (Point& p : body.positions)
    if (d.random.uniform() < share) p = vector_in(d.random, reach);
  return body;
}

Triangles carved(Draw& d) {
  Triangles body =
      carved_ball({Point::Zero(), d.random.uniform(0.5, 0.9), d.random.uniform(0.2, 0.6),
                   d.random.uniform(0.05, 0.15), count(d, 1, 1000), d.large ? 0.08 : 0.35});
  return placed(std::move(body), d, 0.3);
}

Triangles dumbbells(Draw& d) {
  const double radius = d.random.uniform(0.25, 0.5), neck = d.random.uniform(0.02, 0.6) * radius;
  if (d.large)
    return turned(dumbbell({Point::Zero(), radius, 3 * radius, neck, 0.2 * radius, 0.15}), d);
  std::vector<std::vector<Point>> stations;
  const int sides = count(d, 3, 7), rows = count(d, 6, 12);
  for (int s = 0; s <= rows; ++s) {
    const double z = 2.0 * s / rows - 1;
    const double r = neck + (radius - neck) * std::pow(std::sin(std::numbers::pi * z), 2);
    auto& station = stations.emplace_back();
    for (const Point& p : circle(r, sides)) station.push_back(p + Point(0, 0, z));
  }
  return turned(sweep(stations, Ends::capped), d);
}

/// Boxes on the lattice's planes or between them, beside, on and in one another.
Triangles boxes(Draw& d) {
  std::vector<Triangles> bodies;
  for (int b = count(d, 1, 4); b > 0; --b) {
    const double unit = one_in(d, 3) ? d.cell / 2 : d.cell;
    Point size, low;
    for (int a = 0; a < 3; ++a) {
      size[a] = unit * count(d, 1, static_cast<int>(std::max(1.0, 1.2 / unit)));
      low[a] = unit * std::round(d.random.uniform(-0.8, 0.8) / unit);
    }
    bodies.push_back(box({low + size / 2, size, d.large ? 0.15 : d.random.uniform(0.5, 2)}));
  }
  return merged(bodies);
}

/// A body in a cavity of a body in a cavity; now and then a shell that is not inside anything.
Triangles nested(Draw& d) {
  std::vector<Triangles> bodies;
  double scale = 1;
  const Triangles first = one_in(d, 2) ? box({Point::Zero(), Point::Constant(1.4), 1}) : blob(d);
  for (int b = count(d, 2, 5); b > 0; --b) {
    Triangles shell = scaled(first, scale);
    if (one_in(d, 4)) shell = placed(std::move(shell), d, 0.4);
    bodies.push_back(bodies.size() % 2 == 1 || one_in(d, 8) ? inverted(std::move(shell))
                                                            : std::move(shell));
    scale *= one_in(d, 5) ? 1 : d.random.uniform(0.4, 0.98);
  }
  return merged(bodies);
}

/// Thin needles over many cells, oblique to every axis.
Triangles needles(Draw& d) {
  std::vector<Triangles> bodies;
  const double thin = std::ldexp(1.0, -count(d, 3, 40));
  for (int b = count(d, 1, 4); b > 0; --b) {
    const Point from = vector_in(d.random, 1.2);
    Point to = vector_in(d.random, 1.2);
    if (one_in(d, 4)) to = from + Point(0, 0, 1) + vector_in(d.random, 0x1p-20);
    bodies.push_back(tube({from, to}, {thin, count(d, 3, 4), Ends::capped}));
  }
  bodies.push_back(placed(blob(d), d, 0.3));
  return merged(bodies);
}

/// Bodies and exact copies of them; cavities, inversions and zeros with a sign tell some apart.
Triangles copies(Draw& d) {
  const Triangles body = placed(one_in(d, 2) ? blob(d) : boxes(d), d, 0.4);
  std::vector<Triangles> bodies{body};
  for (int b = count(d, 1, 3); b > 0; --b) {
    Triangles copy = body;
    if (one_in(d, 4)) copy = inverted(std::move(copy));
    if (one_in(d, 4)) copy = scaled(std::move(copy), d.random.uniform(0.5, 1));
    if (one_in(d, 4)) copy.positions[0][0] = std::nextafter(copy.positions[0][0], 9.0);
    if (one_in(d, 4)) copy = placed(std::move(copy), d, d.cell);
    bodies.push_back(std::move(copy));
  }
  if (one_in(d, 2)) bodies.push_back(placed(blob(d), d));
  return merged(bodies);
}

/// Flat tetrahedra and split triangles: no area, no volume, collinear corners.
Triangles slivers(Draw& d) {
  std::vector<Triangles> bodies;
  for (int b = count(d, 2, 8); b > 0; --b) {
    Triangles body{{vector_in(d.random, 1), vector_in(d.random, 1), vector_in(d.random, 1), {}},
                   {{0, 1, 2}, {1, 0, 3}, {2, 1, 3}, {0, 2, 3}}};
    const double u = d.random.uniform(-0.2, 1.2), v = one_in(d, 2) ? 0 : d.random.uniform(-0.2, 1);
    body.positions[3] = body.positions[0] + u * (body.positions[1] - body.positions[0]) +
                        v * (body.positions[2] - body.positions[0]);
    if (one_in(d, 3)) body.positions[3] += vector_in(d.random, 0x1p-30);
    bodies.push_back(std::move(body));
  }
  Triangles main = placed(blob(d), d, 0.3);
  for (int k = count(d, 0, 6); k > 0; --k) {  // a vertex on an edge or in a triangle
    const Triangle t = main.triangles[d.random.below(main.triangles.size())];
    const Point &a = main.positions[t[0]], &b = main.positions[t[1]], &c = main.positions[t[2]];
    const double u = d.random.uniform(), v = one_in(d, 2) ? 0 : (1 - u) * d.random.uniform();
    const auto m = static_cast<std::uint32_t>(main.positions.size());
    main.positions.push_back(Point(a + u * (b - a) + v * (c - a)));
    for (Triangle& old : main.triangles)
      if (old == t) old = {t[0], t[1], m};
    main.triangles.push_back({t[1], t[2], m});
    main.triangles.push_back({t[2], t[0], m});
  }
  bodies.push_back(std::move(main));
  return merged(bodies);
}

struct Maker {
  const char* name;
  Triangles (*make)(Draw&);
};
constexpr std::array<Maker, 13> kMakers = {{{"blobs", blobs},
                                            {"boxes", boxes},
                                            {"carved", carved},
                                            {"copies", copies},
                                            {"dumbbells", dumbbells},
                                            {"needles", needles},
                                            {"nested", nested},
                                            {"roll", roll},
                                            {"sheets", sheets},
                                            {"slivers", slivers},
                                            {"soup", soup},
                                            {"tangle", tangle},
                                            {"tori", tori}}};

}  // namespace

std::vector<std::string> generator_names() {
  std::vector<std::string> names;
  for (const Maker& maker : kMakers) names.emplace_back(maker.name);
  return names;
}

Triangles generate(const std::string& name, Draw draw) {
  for (const Maker& maker : kMakers)
    if (name == maker.name) return maker.make(draw);
  throw InvalidInput("there is no generator \"" + name + "\"; there are " +
                     joined(generator_names()));
}

}  // namespace suture::sims
