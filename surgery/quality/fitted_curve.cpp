// The surface over an edge, as the vertices around it tell it [§6.2; Cazals and Pouget 2005].
#include "surgery/quality/fitted_curve.h"

#include <Eigen/Cholesky>
#include <Eigen/Geometry>
#include <boost/container/small_vector.hpp>

#include <algorithm>
#include <cmath>
#include <limits>

#include "surgery/quality/shape.h"

namespace suture::surgery {

namespace {

constexpr int kRings = 2;
constexpr int kHighest = 4, kLowest = 2;  // degrees; 4 has a third of the error of 3 in Enright's
                                          // test at its turn, and 2 has three times that of 4
constexpr int kMostTerms = (kHighest + 1) * (kHighest + 2) / 2;
constexpr std::size_t kSpare = 2;    // samples more than terms, so that there is a residual
constexpr std::size_t kMost = 64;    // samples; two rings have about 30
constexpr double kFacing = 0.5;      // cosine of the most that a normal may lean over
constexpr double kNear = 0.05;       // squared edges: within it samples count alike
constexpr double kMostHeight = 0.5;  // edges: beyond it the surface is not one over this plane

/// A vertex over the edge's frame, in lengths of the edge from its middle.
struct Sample {
  double x, y, height, weight;
};
using Samples = boost::container::small_vector<Sample, kMost>;
using Terms = Eigen::Matrix<double, Eigen::Dynamic, 1, 0, kMostTerms, 1>;
using Gram = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, 0, kMostTerms, kMostTerms>;
using Vertices = boost::container::small_vector<Mesh::Vertex_index, kMost>;

/// The edge's ends, and after them the vertices of the rings, in the order of the mesh.
Vertices rings_around(const Mesh& mesh, Mesh::Halfedge_index h) {
  Vertices found{mesh.source(h), mesh.target(h)};
  std::size_t next = 0;
  for (int ring = 0; ring < kRings; ++ring)
    for (const std::size_t end = found.size(); next < end; ++next)
      for (const auto g : mesh.halfedges_around_target(mesh.halfedge(found[next]))) {
        if (found.size() == kMost) return found;
        if (std::find(found.begin(), found.end(), mesh.source(g)) == found.end())
          found.push_back(mesh.source(g));
      }
  return found;
}

/// Monomials x^i y^j of total degree up to `degree`, those of x alone first.
Terms monomials(const Sample& s, int degree) {
  Terms terms((degree + 1) * (degree + 2) / 2);
  int at = 0;
  double power = 1;
  for (int j = 0; j <= degree; ++j, power *= s.y) {
    double term = power;
    for (int i = 0; i + j <= degree; ++i, term *= s.x) terms[at++] = term;
  }
  return terms;
}

struct Fit {
  Terms coefficients;
  double error = std::numeric_limits<double>::infinity();  ///< an estimate, in lengths of the edge
};

/// Weighted least squares. The height at the origin is a sum of the samples' heights, each times
/// some factor; so the residual, times the sum of the factors' sizes, is what it may be off by.
Fit fitted(const Samples& samples, int degree) {
  const int n = (degree + 1) * (degree + 2) / 2;
  Fit fit;
  if (samples.size() < static_cast<std::size_t>(n) + kSpare) return fit;
  Gram gram = Gram::Zero(n, n);
  Terms right = Terms::Zero(n);
  double weights = 0;
  for (const Sample& s : samples) {
    const Terms terms = monomials(s, degree);
    gram += s.weight * terms * terms.transpose();
    right += s.weight * s.height * terms;
    weights += s.weight;
  }
  const Eigen::LDLT<Gram> solver(gram);
  const Terms origin = solver.solve(Terms::Unit(n, 0));
  fit.coefficients = solver.solve(right);
  double squares = 0, factors = 0;
  for (const Sample& s : samples) {
    const Terms terms = monomials(s, degree);
    const double residual = terms.dot(fit.coefficients) - s.height;
    squares += s.weight * residual * residual;
    factors += s.weight * std::abs(terms.dot(origin));
  }
  const auto count = static_cast<double>(samples.size());
  const double error = factors * std::sqrt(squares / weights * count / (count - n));
  if (fit.coefficients.allFinite() && std::isfinite(error)) fit.error = error;
  return fit;
}

}  // namespace

std::optional<FittedCurve> FittedCurve::fit(const Mesh& mesh, Mesh::Halfedge_index h) {
  FittedCurve curve;
  const Vertices around = rings_around(mesh, h);
  curve.source_ = to_point(mesh.point(around[0]));
  curve.along_ = to_point(mesh.point(around[1])) - curve.source_;
  const double length = curve.along_.norm();
  const Point x = curve.along_ / length, middle = curve.source_ + curve.along_ / 2;
  const Point facing = vertex_normal(mesh, around[0]) + vertex_normal(mesh, around[1]);
  const Point n = (facing - facing.dot(x) * x).normalized();
  if (!n.allFinite()) return std::nullopt;
  curve.normal_ = n;
  Samples samples;
  for (std::size_t i = 0; i < around.size(); ++i) {
    if (!(vertex_normal(mesh, around[i]).dot(n) > kFacing)) {
      if (i < 2) return std::nullopt;
      continue;
    }
    const Point d = (to_point(mesh.point(around[i])) - middle) / length;
    const double near = d.squaredNorm() + kNear;
    samples.push_back({d.dot(x), d.dot(n.cross(x)), d.dot(n), 1 / (near * near)});
  }
  Fit best;
  for (int degree = kHighest; degree >= kLowest; --degree) {
    Fit one = fitted(samples, degree);
    if (one.error < best.error) best = std::move(one);
    if (best.error == 0) break;
  }
  if (!std::isfinite(best.error) || !(std::abs(best.coefficients[0]) < kMostHeight))
    return std::nullopt;
  for (std::size_t i = 0; i < curve.heights_.size(); ++i)
    if (static_cast<Eigen::Index>((i + 1) * (i + 2) / 2) <= best.coefficients.size())
      curve.heights_[i] = best.coefficients[static_cast<Eigen::Index>(i)];
  return curve;
}

Point FittedCurve::at(double part) const {
  const double x = part - 0.5;
  double height = 0;
  for (std::size_t i = heights_.size(); i-- > 0;) height = height * x + heights_[i];
  return source_ + part * along_ + height * along_.norm() * normal_;
}

}  // namespace suture::surgery
