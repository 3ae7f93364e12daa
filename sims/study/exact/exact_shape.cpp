// A start shape as it is meant, not as its mesh has it: smooth faces, creases and its volume.
#include "sims/study/exact/exact_shape.h"

#include <boost/math/quadrature/gauss.hpp>
#include <cmath>
#include <numbers>

#include "kernel/measure/measures.h"
#include "kernel/shapes/shapes.h"

namespace suture::sims {
namespace {

constexpr double kPi = std::numbers::pi;
constexpr int kSphereParts = 24;      // of an icosahedron's edge: 11,520 triangles to begin with
constexpr double kZalesakEdge = 0.1;  // of the radius

double given(const PlacedShape& body, const std::string& key, double otherwise) {
  const auto at = body.parameters.find(key);
  return at == body.parameters.end() ? otherwise : at->second;
}

/// A body's mesh with its faces; `face` has that of each triangle.
struct Body {
  Triangles mesh;
  std::vector<std::uint32_t> face;
  std::vector<ExactFace> faces;
};

/// Adds a body in the scene's coordinates.
void append(ExactShape& shape, const Body& body) {
  const auto& [mesh, face, faces] = body;
  const auto vertices = static_cast<std::uint32_t>(shape.mesh.positions.size());
  const auto first = static_cast<std::uint32_t>(shape.faces.size());
  shape.mesh.positions.insert(shape.mesh.positions.end(), mesh.positions.begin(),
                              mesh.positions.end());
  for (const auto& [a, b, c] : mesh.triangles)
    shape.mesh.triangles.push_back({a + vertices, b + vertices, c + vertices});
  for (const std::uint32_t f : face) shape.face.push_back(f + first);
  shape.faces.insert(shape.faces.end(), faces.begin(), faces.end());
}

void place(Triangles& mesh, std::vector<ExactFace>& faces, const PlacedShape& body) {
  for (Point& p : mesh.positions) p = body.turn * (body.scale * p) + body.move;
  for (ExactFace& f : faces) {
    f.at = body.turn * (body.scale * f.at) + body.move;
    f.normal = body.turn * f.normal;
    f.radius *= body.scale;
  }
}

Point centre_of(const PlacedShape& body, const Point& otherwise) {
  return {given(body, "x", otherwise[0]), given(body, "y", otherwise[1]),
          given(body, "z", otherwise[2])};
}

void add_sphere(ExactShape& shape, const PlacedShape& body) {
  SphereParameters p;
  p.radius = given(body, "radius", p.radius);
  p.centre = centre_of(body, p.centre);
  p.frequency = kSphereParts;
  Triangles mesh = sphere(p);
  std::vector<ExactFace> faces = {{ExactFace::Kind::sphere, p.centre, Point::UnitZ(), p.radius}};
  place(mesh, faces, body);
  append(shape, {mesh, std::vector<std::uint32_t>(mesh.triangles.size(), 0), faces});
  shape.volume += 4 * kPi / 3 * std::pow(p.radius * body.scale, 3);
}

/// The ball less its slot: discs across x, each less its segment below the floor.
double slotted_volume(const ZalesakParameters& p) {
  const auto below = [&](double x) {
    const double r2 = p.radius * p.radius - x * x, r = std::sqrt(r2);
    return r2 * (kPi - std::acos(p.slot_top / r)) +
           p.slot_top * std::sqrt(r2 - p.slot_top * p.slot_top);
  };
  const double half = p.slot_width / 2;
  const double slot = 2 * boost::math::quadrature::gauss<double, 30>::integrate(below, 0.0, half);
  return 4 * kPi / 3 * std::pow(p.radius, 3) - slot;
}

void add_zalesak(ExactShape& shape, const PlacedShape& body) {
  ZalesakParameters p;
  p.radius = given(body, "radius", p.radius);
  p.slot_width = given(body, "slot_width", p.slot_width);
  p.slot_top = given(body, "slot_top", p.slot_top);
  p.centre = centre_of(body, p.centre);
  p.edge_length = kZalesakEdge * p.radius;
  Triangles mesh = zalesak(p);
  using Kind = ExactFace::Kind;
  const double half = p.slot_width / 2;
  std::vector<ExactFace> faces = {
      {Kind::sphere, p.centre, Point::UnitZ(), p.radius},
      {Kind::plane, p.centre - half * Point::UnitX(), Point::UnitX(), 0},
      {Kind::plane, p.centre + half * Point::UnitX(), Point::UnitX(), 0},
      {Kind::plane, p.centre + p.slot_top * Point::UnitY(), Point::UnitY(), 0}};
  std::vector<std::uint32_t> face;
  for (const Triangle& t : mesh.triangles) {
    std::uint32_t of = 0;
    for (std::uint32_t f = 1; f < 4; ++f) {
      double off = 0;
      for (const std::uint32_t v : t)
        off = std::max(off, std::abs(faces[f].normal.dot(mesh.positions[v] - faces[f].at)));
      if (off < 1e-9 * p.radius) of = f;
    }
    face.push_back(of);
  }
  place(mesh, faces, body);
  append(shape, {mesh, face, faces});
  shape.volume += slotted_volume(p) * std::pow(body.scale, 3);
}

/// The first vertex and triangle of a body in the scene's surface.
struct First {
  std::size_t vertex = 0, triangle = 0;
};

/// The part of the scene's surface that is this body.
Triangles part_of(const Triangles& surface, const First& first, const PlacedShape& body) {
  const auto& [vertex, triangle] = first;
  Triangles part;
  const auto v = surface.positions.begin() + static_cast<std::ptrdiff_t>(vertex);
  part.positions.assign(v, v + static_cast<std::ptrdiff_t>(body.vertices));
  for (std::size_t t = triangle; t < triangle + body.triangles; ++t) {
    Triangle moved = surface.triangles[t];
    for (std::uint32_t& i : moved) i -= static_cast<std::uint32_t>(vertex);
    part.triangles.push_back(moved);
  }
  return part;
}

/// A sphere's or a circle's point in the direction of p from its centre.
Point pushed(const Point& p, const Point& centre, double radius) {
  const Point d = p - centre;
  const double length = d.norm();
  return length > 0 ? Point(centre + radius / length * d) : p;
}

}  // namespace

ExactShape exact_shape(const Scene& scene, const ExactShapeOptions& options) {
  ExactShape shape;
  First first;
  for (const PlacedShape& body : scene.shapes) {
    if (!options.polyhedron && body.shape == "sphere") {
      add_sphere(shape, body);
    } else if (!options.polyhedron && body.shape == "zalesak") {
      add_zalesak(shape, body);
    } else {
      const Triangles part = part_of(scene.surface, first, body);
      append(shape, {part, std::vector<std::uint32_t>(part.triangles.size(), 0), {ExactFace{}}});
      shape.volume += volume(part);
      shape.exact = false;
    }
    first.vertex += body.vertices;
    first.triangle += body.triangles;
  }
  return shape;
}

Point onto(const Point& p, const ExactFace& face) {
  return face.kind == ExactFace::Kind::sphere ? pushed(p, face.at, face.radius) : p;
}

Point middle_on(const Point& a, const Point& b, const ExactFace& f, const ExactFace& g) {
  const Point m = (a + b) / 2;
  using Kind = ExactFace::Kind;
  if (f.kind == Kind::sphere && g.kind == Kind::sphere) return onto(m, f);
  if (f.kind == Kind::plane && g.kind == Kind::sphere) return middle_on(a, b, g, f);
  if (f.kind != Kind::sphere || g.kind != Kind::plane) return m;
  const double off = g.normal.dot(g.at - f.at);
  return pushed(m, f.at + off * g.normal, std::sqrt(f.radius * f.radius - off * off));
}

bool is_crease(const ExactFace& f, const ExactFace& g) {
  return &f != &g && f.kind != ExactFace::Kind::flat && g.kind != ExactFace::Kind::flat;
}

}  // namespace suture::sims
