// The equations of an implicit viscous step: masses, and stresses between faces.
#include "sims/fluid/effects/viscous_system.h"

#include <algorithm>
#include <cmath>

#include "kernel/errors.h"
#include "sims/fluid/effects/rigid_part.h"

namespace suture::sims {
namespace {

using Numbers = std::array<std::vector<std::uint32_t>, 3>;

ViscousSystem::Term term(const RateStencil& r, const StrainRate& rate, const MacVelocity& velocity,
                         const Numbers& numbers) {
  ViscousSystem::Term t;
  for (int n = 0; n < r.faces; ++n) {
    const auto way = static_cast<float>(r.coefficient[n]);
    t.unknown[n] = numbers[r.axis[n]][r.slot[n]];
    if (t.unknown[n] == kNone) {
      t.constant += way * rate.velocity_at(velocity, r.axis[n], r.slot[n]);
      t.wall = true;
    } else {
      t.way[n] = way;
    }
  }
  return t;
}

double mass(const MacVelocity& velocity, const StrainRate& rate, const Liquid* projected, int axis,
            Slot s) {
  if (velocity.known[axis][s] == 0) return 0;
  if (projected != nullptr && !touches(*projected, axis, s)) return 0;
  return rate.share(axis, s);
}

void number_faces(ViscousSystem& system, Numbers& numbers, const MacVelocity& velocity,
                  const StrainRate& rate, const Liquid* projected, bool only_massless) {
  for (int a = 0; a < 3; ++a) numbers[a].assign(rate.grid().size(), kNone);
  rate.for_each([&](const RateStencil& r, int, Slot) {
    for (int n = 0; n < r.faces; ++n)
      if (!rate.held(r.axis[n], r.slot[n])) numbers[r.axis[n]][r.slot[n]] = 0;
  });
  for (Slot s = 0; s < rate.grid().size(); ++s)
    for (int a = 0; a < 3; ++a) {
      if (numbers[a][s] == kNone) continue;
      const double own = mass(velocity, rate, projected, a, s);
      if (only_massless && own > 0) {
        numbers[a][s] = kNone;
        continue;
      }
      const double u = rate.velocity_at(velocity, a, s);
      if (!std::isfinite(u))
        throw InvalidInput("the velocity is not finite at a face across axis " + std::to_string(a) +
                           "; check what moved it in the step before");
      numbers[a][s] = static_cast<std::uint32_t>(system.faces.size());
      system.faces.push_back({s, a});
      system.before.push_back(u);
      system.mass.push_back(own);
    }
}

double norm(const std::vector<double>& x, const std::vector<double>& scale) {
  double sum = 0;
  for (std::size_t i = 0; i < x.size(); ++i) sum += x[i] * x[i] * scale[i] * scale[i];
  return std::sqrt(sum);
}

/// What each row of the gradient lacks to 0. With `rigid`, v has no strain rate off the walls,
/// which a sum would give only to rounding.
std::vector<double> residual(const ViscousSystem& system, const std::vector<double>& v,
                             bool rigid) {
  std::vector<double> r(v.size());
  for (std::size_t i = 0; i < v.size(); ++i) r[i] = system.mass[i] * (system.before[i] - v[i]);
  for (const ViscousSystem::Term& t : system.terms) {
    const double value = t.constant + (rigid && !t.wall ? 0 : t.of(v));
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
  return at_rest + norm(residual(system, v, true), scale);
}

/// Where there is no liquid in a face's control volume, what the terms round it leave free of its
/// velocity means nothing: this part of the diagonal keeps that from changing.
constexpr double kPinned = 1e-9;

/// What is left of the strain that these faces can take up: in a stiff liquid its energy counts.
constexpr SolverOptions kRelaxing{1e-8, 500};
/// A residual of so little of its parts is the rounding of these.
constexpr double kRounding = 1e-13;

constexpr std::size_t kWidest = 15;  // entries of a row: itself, and 2 + 4·3 of its six terms

/// The matrix with its rows and columns multiplied by `scale`.
SparseRows matrix(const ViscousSystem& system, const std::vector<double>& scale) {
  const std::size_t rows = scale.size();
  SparseRows m;
  m.column.assign(rows * kWidest, 0);
  m.value.assign(rows * kWidest, 0);
  std::vector<std::uint8_t> used(rows, 1);
  for (std::size_t i = 0; i < rows; ++i) {
    m.column[i * kWidest] = static_cast<std::uint32_t>(i);
    m.value[i * kWidest] = system.mass[i] > 0 ? system.mass[i] * scale[i] * scale[i] : kPinned;
  }
  for (const ViscousSystem::Term& t : system.terms)
    for (int a = 0; a < 4; ++a)
      for (int b = 0; b < 4; ++b) {
        const std::uint32_t i = t.unknown[a], j = t.unknown[b];
        if (i == kNone || j == kNone) continue;
        std::size_t at = i * kWidest;
        const std::size_t end = at + used[i];
        while (at < end && m.column[at] != j) ++at;
        if (at == end) {
          m.column[at] = j;
          ++used[i];
        }
        m.value[at] += t.stiffness * (t.way[a] * scale[i]) * (t.way[b] * scale[j]);
      }
  m.first.assign(rows + 1, 0);
  std::size_t to = 0;
  for (std::size_t i = 0; i < rows; ++i) {
    for (std::size_t n = 0; n < used[i]; ++n, ++to) {
      m.column[to] = m.column[i * kWidest + n];
      m.value[to] = m.value[i * kWidest + n];
    }
    m.first[i + 1] = to;
  }
  m.column.resize(to);
  m.value.resize(to);
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

std::size_t ViscousSystem::memory() const {
  return faces.capacity() * sizeof(Face) + bytes(mass) + bytes(before) +
         terms.capacity() * sizeof(Term);
}

ViscousSystem viscous_system(const MacVelocity& velocity, const StrainRate& rate,
                             const StressStep& step, bool only_massless) {
  ViscousSystem system;
  system.grid = &rate.grid();
  Numbers numbers;
  number_faces(system, numbers, velocity, rate, step.projected, only_massless);
  std::array<std::size_t, 3> held{};
  rate.for_each([&](const RateStencil& r, int component, Slot s) {
    ViscousSystem::Term t = term(r, rate, velocity, numbers);
    const double twice = component < 3 ? 1 : 2;  // a shear's stencil makes 2h·D
    t.stiffness = step.stiffness * r.weight * 2 / twice;
    if (step.factor != nullptr) t.stiffness *= step.factor->part(component)[s];
    if (step.offset != nullptr) t.constant += twice * step.offset->part(component)[s];
    const bool free =
        std::any_of(t.unknown.begin(), t.unknown.end(), [](std::uint32_t u) { return u != kNone; });
    if (!free) return;
    system.terms.push_back(t);
    for (int n = 0; n < r.faces; ++n) {
      if (t.unknown[n] != kNone) continue;
      system.wall_velocity[r.axis[n]] += rate.velocity_at(velocity, r.axis[n], r.slot[n]);
      ++held[r.axis[n]];
    }
  });
  for (int a = 0; a < 3; ++a)
    if (held[a] != 0) system.wall_velocity[a] /= static_cast<double>(held[a]);
  return system;
}

DiffusionReport solve(const ViscousSystem& system, std::vector<double>& v,
                      const SolverOptions& options) {
  DiffusionReport report;
  v.assign(system.faces.size(), 0);
  const std::vector<double> scale = scales(system);
  const double size = size_of(system, scale);
  if (size == 0) return report;
  const RigidPart rigid(system);
  rigid.correct(v);
  std::vector<double> rest = residual(system, v, true);
  double from = norm(rest, scale);
  if (std::vector<double> other = residual(system, system.before, false);
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

void relax_massless(MacVelocity& velocity, const StrainRate& rate, const StressStep& step) {
  const ViscousSystem system = viscous_system(velocity, rate, step, true);
  const std::vector<double> scale = scales(system);
  std::vector<double> v = system.before;
  std::vector<double> rest = residual(system, v, false);
  const double size = norm(rest, scale);
  const double rounding = norm(residual(system, std::vector<double>(v.size(), 0), false), scale);
  if (!(size > kRounding * rounding)) return;
  for (std::size_t i = 0; i < v.size(); ++i) rest[i] *= scale[i] / size;
  std::vector<double> change;
  solve(matrix(system, scale), rest, change, kRelaxing);
  for (std::size_t i = 0; i < v.size(); ++i) {
    const auto [slot, axis] = system.faces[i];
    velocity.u[axis][slot] = v[i] + size * scale[i] * change[i];
    velocity.known[axis][slot] = 1;
  }
}

}  // namespace suture::sims
