// An implicit step of a viscous stress: the viscous system, solved, and the velocities it gives.
#include "sims/fluid/effects/stress/stress_step.h"

#include <cmath>
#include <utility>

#include "sims/fluid/effects/stress/rigid_part.h"
#include "sims/fluid/linear/linear_solver.h"

namespace suture::sims {
namespace {

double norm(const std::vector<double>& x, const std::vector<double>& scale) {
  double sum = 0;
  for (std::size_t i = 0; i < x.size(); ++i) sum += x[i] * x[i] * scale[i] * scale[i];
  return std::sqrt(sum);
}

/// A rigid motion has no strain rate off the walls, which a sum would give only to rounding.
enum class Motion { any, rigid };

/// The residual: what each row of the gradient lacks to 0, with the motion v.
std::vector<double> residual(const ViscousSystem& system, const std::vector<double>& v,
                             Motion motion) {
  std::vector<double> r(v.size());
  for (std::size_t i = 0; i < v.size(); ++i) r[i] = system.mass[i] * (system.before[i] - v[i]);
  for (const ViscousSystem::Term& t : system.terms) {
    const double value = t.constant + (motion == Motion::rigid && !t.wall ? 0 : t.of(v));
    for (int n = 0; n < 4; ++n)
      if (t.unknown[n] != kNone) r[t.unknown[n]] -= t.stiffness * t.way[n] * value;
  }
  return r;
}

/// The size of the right side, whatever the whole scene's velocity.
double size_of(const ViscousSystem& system, const std::vector<double>& scale) {
  std::vector<double> v(scale.size());
  for (std::size_t i = 0; i < v.size(); ++i) v[i] = system.mass[i] * system.before[i];
  const double at_rest = norm(v, scale);
  for (std::size_t i = 0; i < v.size(); ++i) v[i] = system.wall_velocity[system.faces[i].axis];
  return at_rest + norm(residual(system, v, Motion::rigid), scale);
}

/// The velocity of a face without liquid in its control volume means nothing as far as the terms
/// round it leave it free: this part of the diagonal keeps it from changing.
constexpr double kPinned = 1e-9;

/// The faces without mass take up strain to this tolerance: in a stiff liquid the rest's energy
/// counts.
constexpr SolverOptions kRelaxing{1e-8, 500};
/// A residual of so little of its parts is the rounding of these.
constexpr double kRounding = 1e-13;

constexpr std::size_t kWidest = 15;  // entries of a row: itself, and 2 + 4·3 of its six terms

/// Rows of kWidest entries each, of which row i has the first used[i].
struct WideRows {
  std::vector<std::uint32_t> column;
  std::vector<double> value;
  std::vector<std::uint8_t> used;

  explicit WideRows(std::size_t rows)
      : column(rows * kWidest, 0), value(rows * kWidest, 0), used(rows, 1) {}

  /// The entry of row i in column j.
  double& at(std::uint32_t i, std::uint32_t j) {
    std::size_t n = i * kWidest;
    const std::size_t end = n + used[i];
    while (n < end && column[n] != j) ++n;
    if (n == end) {
      column[n] = j;
      ++used[i];
    }
    return value[n];
  }

  SparseRows compressed() && {
    SparseRows m{{}, std::move(column), std::move(value), {}};
    m.first.assign(used.size() + 1, 0);
    std::size_t to = 0;
    for (std::size_t i = 0; i < used.size(); ++i) {
      for (std::size_t n = 0; n < used[i]; ++n, ++to) {
        m.column[to] = m.column[i * kWidest + n];
        m.value[to] = m.value[i * kWidest + n];
      }
      m.first[i + 1] = to;
    }
    m.column.resize(to);
    m.value.resize(to);
    return m;
  }
};

/// The matrix with its rows and columns multiplied by `scale`.
SparseRows matrix(const ViscousSystem& system, const std::vector<double>& scale) {
  WideRows rows(scale.size());
  for (std::size_t i = 0; i < scale.size(); ++i) {
    rows.column[i * kWidest] = static_cast<std::uint32_t>(i);
    rows.value[i * kWidest] = system.mass[i] > 0 ? system.mass[i] * scale[i] * scale[i] : kPinned;
  }
  for (const ViscousSystem::Term& t : system.terms)
    for (int a = 0; a < 4; ++a)
      for (int b = 0; b < 4; ++b) {
        const std::uint32_t i = t.unknown[a], j = t.unknown[b];
        if (i == kNone || j == kNone) continue;
        rows.at(i, j) += t.stiffness * (t.way[a] * scale[i]) * (t.way[b] * scale[j]);
      }
  SparseRows m = std::move(rows).compressed();
  for (const ViscousSystem::Face& f : system.faces)
    m.component.push_back(static_cast<std::uint8_t>(f.axis));
  return m;
}

std::vector<double> scales(const ViscousSystem& system) {
  std::vector<double> scale = system.mass;
  for (const ViscousSystem::Term& t : system.terms)
    for (int n = 0; n < 4; ++n)
      if (t.unknown[n] != kNone)
        scale[t.unknown[n]] += t.stiffness * (static_cast<double>(t.way[n]) * t.way[n]);
  for (double& s : scale) s = 1 / std::sqrt(s);
  return scale;
}

std::size_t bytes(const std::vector<double>& x) { return x.capacity() * sizeof(double); }

}  // namespace

DiffusionReport solve(const ViscousSystem& system, std::vector<double>& v,
                      const SolverOptions& options) {
  DiffusionReport report;
  v.assign(system.faces.size(), 0);
  const std::vector<double> scale = scales(system);
  const double size = size_of(system, scale);
  if (size == 0) return report;
  const RigidPart rigid(system);
  rigid.correct(v);
  std::vector<double> rest = residual(system, v, Motion::rigid);
  double from = norm(rest, scale);
  if (std::vector<double> other = residual(system, system.before, Motion::any);
      norm(other, scale) < from) {  // little happens: start from the velocity before
    from = norm(other, scale);
    rest = std::move(other);
    v = system.before;
  }
  report.memory = system.memory() + rigid.memory() + bytes(v) + bytes(scale) + 2 * bytes(rest);
  report.residual = from / size;
  if (report.residual <= options.tolerance) return report;
  for (std::size_t i = 0; i < rest.size(); ++i) rest[i] *= scale[i] / from;
  const SparseRows rows = matrix(system, scale);
  std::vector<double> change;
  SolverOptions own = options;
  own.tolerance *= size / from;
  static_cast<SolveReport&>(report) = solve(rows, rest, change, own);
  report.memory += bytes(change) + rows.first.capacity() * sizeof(std::size_t) +
                   rows.column.capacity() * sizeof(std::uint32_t) + bytes(rows.value);
  report.residual *= from / size;
  for (std::size_t i = 0; i < v.size(); ++i) v[i] += from * scale[i] * change[i];
  rigid.correct(v);
  return report;
}

DiffusionReport step_stress(MacVelocity& velocity, const StrainRate& rate, const StressStep& step,
                            const SolverOptions& options) {
  const ViscousSystem system = viscous_system(velocity, rate, step);
  std::vector<double> v;
  const DiffusionReport report = solve(system, v, options);
  for (std::size_t i = 0; i < v.size(); ++i) {
    const auto [slot, axis] = system.faces[i];
    if (velocity.known[axis][slot] != 0) velocity.u[axis][slot] = v[i];
  }
  rate.for_each([&](const RateStencil& r, int, Slot) {
    for (int n = 0; n < r.faces; ++n)
      if (rate.held(r.axis[n], r.slot[n])) {
        velocity.u[r.axis[n]][r.slot[n]] = rate.velocity_at(velocity, r.axis[n], r.slot[n]);
        velocity.known[r.axis[n]][r.slot[n]] = 1;
      }
  });
  return report;
}

SolveReport relax_massless(MacVelocity& velocity, const StrainRate& rate, const StressStep& step) {
  const ViscousSystem system = viscous_system(velocity, rate, step, Unknowns::massless);
  const std::vector<double> scale = scales(system);
  std::vector<double> v = system.before;
  std::vector<double> rest = residual(system, v, Motion::any);
  const double size = norm(rest, scale);
  const double rounding =
      norm(residual(system, std::vector<double>(v.size(), 0), Motion::any), scale);
  if (!(size > kRounding * rounding)) return {};
  for (std::size_t i = 0; i < v.size(); ++i) rest[i] *= scale[i] / size;
  std::vector<double> change;
  const SolveReport report = solve(matrix(system, scale), rest, change, kRelaxing);
  for (std::size_t i = 0; i < v.size(); ++i) {
    const auto [slot, axis] = system.faces[i];
    velocity.u[axis][slot] = v[i] + size * scale[i] * change[i];
    velocity.known[axis][slot] = 1;
  }
  return report;
}

}  // namespace suture::sims
