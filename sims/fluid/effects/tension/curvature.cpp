// The mean curvature of a mesh as the physics grid can carry it, and what it cannot.
#include "sims/fluid/effects/tension/curvature.h"

#include <Eigen/IterativeLinearSolvers>
#include <Eigen/SparseCore>
#include <algorithm>
#include <array>
#include <cmath>
#include <complex>

#include "kernel/errors.h"

namespace suture::sims {
namespace {

using Complex = std::complex<double>;
using Matrix = Eigen::SparseMatrix<Complex>;
using Vector = Eigen::VectorXd;

/// The largest cotangent that couples vertices, that of 14°: the tracker's improvement leaves no
/// smaller angle, and what a sliver couples more firmly only takes the solver longer.
constexpr double kMostCotangent = 4;
/// One over twice the area of a triangle with edges of 0.7 cells: a mesh of larger ones is filtered
/// as a grid would be that is coarser by as much.
constexpr double kCoarse = 2.3;
/// × a third of the triangles at a vertex: the least of their area that is its own.
constexpr double kLeastOwn = 0.25;
/// × h²: the least area of a vertex; one without an area of its own follows its neighbours.
constexpr double kLeastArea = 1e-9;
/// Relative; far below what the curvature of a mesh is off by.
constexpr double kTolerance = 1e-7;

bool wet(const Triangle& t, const std::vector<std::uint8_t>* on_solid) {
  return on_solid != nullptr && (*on_solid)[t[0]] != 0 && (*on_solid)[t[1]] != 0 &&
         (*on_solid)[t[2]] != 0;
}

/// A triangle in cells: its sides (side k is opposite corner k), normal × 2·area and 2·area.
struct Shape {
  std::array<Point, 3> side;
  Point normal;
  double twice_area;

  Shape(const Triangles& surface, const Triangle& t, double h) {
    for (int k = 0; k < 3; ++k)
      side[k] = (surface.positions[t[(k + 2) % 3]] - surface.positions[t[(k + 1) % 3]]) / h;
    normal = side[0].cross(side[1]);
    twice_area = normal.norm();
  }
  Point gradient(int k) const {  // of the area by corner k
    return normal.cross(side[k]) / (2 * twice_area);
  }
  double cotangent(int k) const { return -side[(k + 1) % 3].dot(side[(k + 2) % 3]) / twice_area; }
  /// The area that is nearest to corner k; below 0 beside an obtuse angle.
  double own_area(int k) const {
    const int i = (k + 1) % 3, j = (k + 2) % 3;
    return (side[i].squaredNorm() * cotangent(i) + side[j].squaredNorm() * cotangent(j)) / 8;
  }
};

/// Sums over the triangles round each vertex, in units of cells.
struct Forms {
  std::vector<Point> area_gradient, volume_gradient, solid;  ///< solid: sum of wet normals
  Vector own, third;  ///< areas: what is nearest to the vertex; a third of each triangle
  Vector stiffness;   ///< a vertex's own part of the coupling
  std::vector<Eigen::Triplet<Complex>> coupling;

  explicit Forms(std::size_t vertices)
      : area_gradient(vertices, Point::Zero()),
        volume_gradient(area_gradient),
        solid(area_gradient),
        own(Vector::Zero(static_cast<Eigen::Index>(vertices))),
        third(own),
        stiffness(own) {}

  void add(const Shape& shape, const Triangle& t, double smoothing);
};

void Forms::add(const Shape& shape, const Triangle& t, double smoothing) {
  const double spread = smoothing * smoothing * std::max(1.0, kCoarse * shape.twice_area);
  for (int k = 0; k < 3; ++k) {
    const std::uint32_t a = t[(k + 1) % 3], b = t[(k + 2) % 3];
    area_gradient[t[k]] += shape.gradient(k);
    volume_gradient[t[k]] += shape.normal / 6;
    own[t[k]] += shape.own_area(k);
    third[t[k]] += shape.twice_area / 6;
    const double weight = spread / 2 * std::clamp(shape.cotangent(k), 0.0, kMostCotangent);
    stiffness[a] += weight;
    stiffness[b] += weight;
    coupling.emplace_back(a, b, Complex(0, -weight));
    coupling.emplace_back(b, a, Complex(0, -weight));
  }
}

Forms forms_of(const Triangles& surface, double h, const CurvatureOptions& options) {
  Forms forms(surface.positions.size());
  forms.coupling.reserve(6 * surface.triangles.size());
  for (const Triangle& t : surface.triangles) {
    const Shape shape(surface, t, h);
    if (wet(t, options.on_solid))
      for (const std::uint32_t v : t) forms.solid[v] += shape.normal;
    else if (shape.twice_area > 0)
      forms.add(shape, t, options.smoothing);
  }
  return forms;
}

/// The area's gradient along the volume's, at the contact line with their mirror images: of these
/// only what is along the solid remains.
Vector integrated_curvature(const Forms& forms) {
  Vector curvature = Vector::Zero(forms.own.size());
  for (std::size_t v = 0; v < forms.solid.size(); ++v) {
    Point area = forms.area_gradient[v], volume = forms.volume_gradient[v];
    if (const double length = forms.solid[v].norm(); length > 0) {
      const Point normal = forms.solid[v] / length;
      area -= area.dot(normal) * normal;
      volume -= volume.dot(normal) * normal;
    }
    if (const double length = volume.norm(); length > 0)
      curvature[static_cast<Eigen::Index>(v)] = area.dot(volume) / length;
  }
  return curvature;
}

/// The surface as Butterworth's filter sees it, in cells.
class Filter {
 public:
  explicit Filter(const Forms& forms)
      : area_(forms.own.cwiseMax(kLeastOwn * forms.third).cwiseMax(kLeastArea)),
        matrix_(area_.size(), area_.size()) {
    matrix_.setFromTriplets(forms.coupling.begin(), forms.coupling.end());
    Eigen::VectorXcd own(area_.size());
    own.real() = area_;
    own.imag() = forms.stiffness;
    matrix_ += Matrix(own.asDiagonal());
    solver_.setTolerance(kTolerance);
    solver_.compute(matrix_);
  }

  /// The part of something that the filter leaves, and the part that it takes; what is given is
  /// integrated over vertices' areas. The real part of 1/(1 + is) is 1/(1 + s²): with s =
  /// (k·smoothing)² one complex solution filters.
  Vector smooth(const Vector& integrated) {
    Vector left = solver_.solve(integrated.cast<Complex>()).real();
    if (!left.allFinite())
      throw InternalFailure("surface tension", "the filter of the curvature has no solution");
    add_report();
    return left;
  }
  Vector rest(const Vector& integrated) {
    return integrated - area_.cwiseProduct(smooth(integrated));
  }
  /// All solves so far: the iterations of all, the worst of the rest.
  const SolveReport& report() const { return report_; }

 private:
  void add_report() {
    const SolveStatus status = solver_.info() == Eigen::Success ? SolveStatus::converged
                               : solver_.info() == Eigen::NoConvergence
                                   ? SolveStatus::iterations_exhausted
                                   : SolveStatus::broken_down;
    report_.iterations += static_cast<int>(solver_.iterations());
    report_.residual = std::max(report_.residual, static_cast<double>(solver_.error()));
    report_.status = std::max(report_.status, status);
  }

  Vector area_;
  Matrix matrix_;
  Eigen::BiCGSTAB<Matrix> solver_;
  SolveReport report_;
};

void check(const Triangles& surface, double h, const CurvatureOptions& options) {
  if (!(h > 0) || !std::isfinite(h))
    throw InvalidInput("curvature needs cells of a finite positive size, not " + number(h));
  if (options.on_solid != nullptr && options.on_solid->size() != surface.positions.size())
    throw InvalidInput("curvature needs as many flags of solids as the surface has vertices");
}

}  // namespace

std::vector<Point> area_gradient(const Triangles& surface) {
  std::vector<Point> gradient(surface.positions.size(), Point::Zero());
  for (const Triangle& t : surface.triangles)
    if (const Shape shape(surface, t, 1); shape.twice_area > 0)
      for (int k = 0; k < 3; ++k) gradient[t[k]] += shape.gradient(k);
  return gradient;
}

Filtered<double> mean_curvature(const Triangles& surface, double h,
                                const CurvatureOptions& options) {
  check(surface, h, options);
  Filtered<double> result{std::vector<double>(surface.positions.size(), 0), {}};
  if (surface.positions.empty()) return result;
  const Forms forms = forms_of(surface, h, options);
  Filter filter(forms);
  const Vector curvature = filter.smooth(integrated_curvature(forms));
  result.solve = filter.report();
  for (const Triangle& t : surface.triangles)
    if (!wet(t, options.on_solid))
      for (const std::uint32_t v : t) {
        const double in_cells = curvature[static_cast<Eigen::Index>(v)];
        result.values[v] = std::clamp(in_cells, -options.most, options.most) / h;
      }
  return result;
}

Filtered<Point> ripples(const Triangles& surface, double h, const CurvatureOptions& options) {
  check(surface, h, options);
  Filtered<Point> result{std::vector<Point>(surface.positions.size(), Point::Zero()), {}};
  if (surface.positions.empty()) return result;
  const Forms forms = forms_of(surface, h, options);
  Filter filter(forms);
  const Vector size = filter.smooth(filter.rest(integrated_curvature(forms)));
  result.solve = filter.report();
  const double length = h * options.smoothing * options.smoothing;
  for (std::size_t v = 0; v < result.values.size(); ++v) {
    const bool held = options.on_solid != nullptr && (*options.on_solid)[v] != 0;
    const double across = forms.volume_gradient[v].norm();
    if (held || !(across > 0)) continue;
    const double most = size[static_cast<Eigen::Index>(v)];
    result.values[v] = -length * std::clamp(most, -options.most, options.most) *
                       (forms.volume_gradient[v] / across);
  }
  return result;
}

}  // namespace suture::sims
