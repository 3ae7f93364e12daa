// Elasticity of the liquid: it strains, springs back, yields and forgets.
#include "sims/fluid/viscoelasticity.h"

#include <algorithm>
#include <cmath>

#include "kernel/errors.h"
#include "sims/fluid/viscosity.h"

namespace suture {
namespace {

void check(const ElasticOptions& o, double dt) {
  const auto require = [](bool holds, const char* what, double x) {
    if (!holds) throw InvalidInput(std::string("elasticity: ") + what + ", not " + number(x));
  };
  require(o.modulus >= 0 && std::isfinite(o.modulus), "modulus must be finite and at least 0",
          o.modulus);
  require(o.density > 0 && std::isfinite(o.density), "density must be finite and above 0",
          o.density);
  require(o.yield_strain > 0, "yield_strain must be above 0", o.yield_strain);
  require(o.flow_rate >= 0, "flow_rate must be at least 0", o.flow_rate);
  require(o.relaxation_time > 0, "relaxation_time must be above 0", o.relaxation_time);
  require(dt >= 0 && std::isfinite(dt), "a step must be finite and at least 0", dt);
}

/// strain after = kept·(strain before) + time·(strain rate): a rate that is constant over the step,
/// and relaxation, exactly.
struct Memory {
  double kept, time;

  Memory(const ElasticOptions& o, double dt)
      : kept(std::exp(-dt / o.relaxation_time)),
        time(std::isfinite(o.relaxation_time)
                 ? -o.relaxation_time * std::expm1(-dt / o.relaxation_time)
                 : dt) {}
};

/// Of a step in which liquid flows: the first solve takes its stress for elastic, each further one
/// for what would be left of the one before after flow.
constexpr int kFlowSolves = 3;

/// A shear's stencil makes twice its component.
double twice(int component) { return component < 3 ? 1 : 2; }

/// What is left of a strain of this size after it has flowed.
double flowed(double size, const ElasticOptions& o, double dt) {
  if (!(size > o.yield_strain)) return 1;
  return (o.yield_strain + (size - o.yield_strain) * std::exp(-o.flow_rate * dt)) / size;
}

/// The deviatoric strain's size at a cell's middle: of shears, the mean at its edges.
double deviatoric_size(const TensorField& t, const Strain& where, Slot s) {
  const double mean = (t.stretch[0][s] + t.stretch[1][s] + t.stretch[2][s]) / 3;
  double sum = 0;
  for (int a = 0; a < 3; ++a) {
    sum += std::pow(t.stretch[a][s] - mean, 2);
    double squares = 0;
    int count = 0;
    for_each_edge(*where.grid, a, s, [&](Slot edge) {
      if (where.known[1 + a][edge] == 0) return;
      squares += t.shear[a][edge] * t.shear[a][edge];
      ++count;
    });
    if (count != 0) sum += 2 * squares / count;
  }
  return std::sqrt(sum);
}

/// What flow leaves of each component: of a shear, the least of what the cells round it say, so
/// that none of them stays beyond its yield. Without arrays where nothing flows.
TensorField flow_factors(const TensorField& t, const Strain& where, const ElasticOptions& o,
                         double dt) {
  TensorField factors;
  if (!std::isfinite(o.yield_strain)) return factors;
  for (Slot s = 0; s < where.grid->size(); ++s) {
    if (where.known[0][s] == 0) continue;
    const double left = flowed(deviatoric_size(t, where, s), o, dt);
    if (left == 1) continue;
    if (!factors.any()) factors.fill(where.grid->size(), 1);
    for (int a = 0; a < 3; ++a) {
      factors.stretch[a][s] = left;
      for_each_edge(*where.grid, a, s, [&](Slot edge) {
        factors.shear[a][edge] = std::min(factors.shear[a][edge], left);
      });
    }
  }
  return factors;
}

/// Of the strain: the deviatoric part times the factors.
void flow(Strain& strain, const TensorField& factors) {
  if (!factors.any()) return;
  for (Slot s = 0; s < strain.grid->size(); ++s) {
    auto& t = strain.elastic;
    const double mean = (t.stretch[0][s] + t.stretch[1][s] + t.stretch[2][s]) / 3;
    for (int a = 0; a < 3; ++a) {
      t.stretch[a][s] = mean + factors.stretch[a][s] * (t.stretch[a][s] - mean);
      t.shear[a][s] *= factors.shear[a][s];
    }
  }
}

/// How a step weighs the strain rate at its end, and takes off that at its begin, whereby its
/// stress is the one half a step on. Halves keep the energy of what they resolve, and 1 and 0 damp
/// what they do not. Stable when begin ≤ end; with viscosity between, which damps the begin's
/// velocity, only while end ≥ 1/2, though 1/4 of each would be more exact alone [Newmark 1959].
struct Weights {
  double end, begin;

  Weights(double waves_per_cell, double kept) {
    begin = 0.5 * kept / std::max(1.0, waves_per_cell);
    end = 1 - begin;
  }
};

/// One step of the stress, without flow.
class Push {
 public:
  Push(const MacVelocity& before, const Strain& strain, const Liquid& liquid,
       const StrainRate& rate, const ElasticOptions& o, double dt)
      : strain_(strain), liquid_(liquid), rate_(rate), memory_(o, dt) {
    const double h = rate.grid().h();
    const double squared = o.modulus / o.density / h * (dt / h) * memory_.time;
    const Weights weights(std::sqrt(squared), memory_.kept);
    stiffness_ = std::min(squared * weights.end, kStiffest);
    offset_.fill(rate.grid().size(), 0);
    rate.for_each([&](const RateStencil& r, int c, Slot s) {
      const double begin = rate.value(r, before) / twice(c);
      offset_.part(c)[s] =
          (h * memory_.kept / memory_.time * strain.elastic.part(c)[s] - weights.begin * begin) /
          weights.end;
    });
  }

  DiffusionReport act(MacVelocity& velocity, const TensorField& factors,
                      const SolverOptions& solver) const {
    const StressStep step{stiffness_, &offset_, factors.any() ? &factors : nullptr, &liquid_};
    DiffusionReport report = step_stress(velocity, rate_, step, solver);
    report.memory += offset_.memory() + factors.memory();
    return report;
  }

  /// What the strain would be after this velocity.
  TensorField strain_after(const MacVelocity& velocity) const {
    TensorField t;
    t.fill(rate_.grid().size(), 0);
    rate_.for_each([&](const RateStencil& r, int c, Slot s) {
      t.part(c)[s] = memory_.kept * strain_.elastic.part(c)[s] +
                     memory_.time / rate_.grid().h() * rate_.value(r, velocity) / twice(c);
    });
    return t;
  }

 private:
  const Strain& strain_;
  const Liquid& liquid_;
  const StrainRate& rate_;
  Memory memory_;
  double stiffness_;
  TensorField offset_;
};

void mark_known(Strain& strain, const StrainRate& rate) {
  for (auto& k : strain.known) std::fill(k.begin(), k.end(), 0);
  rate.for_each([&](const RateStencil&, int c, Slot s) { strain.known[c < 3 ? 0 : c - 2][s] = 1; });
}

}  // namespace

double largest_step(const ElasticOptions& options, double h) {
  return h * std::sqrt(options.density / options.modulus);
}

Strain unstrained(const SparseGrid& grid, const ElasticOptions& options) {
  check(options, 0);
  return options.modulus > 0 ? Strain(grid) : Strain();
}

DiffusionReport push(MacVelocity& velocity, const Strain& strain, const Liquid& liquid,
                     const SolidFaces& solids, const ElasticOptions& options, double dt,
                     const SolverOptions& solver) {
  check(options, dt);
  if (!strain.any() || dt == 0) return {};
  const Shares shares = liquid_shares(liquid);
  const StrainRate rate(shares, solids, options.no_slip);
  const Push push(velocity, strain, liquid, rate, options, dt);
  const MacVelocity before = velocity;
  DiffusionReport report = push.act(velocity, {}, solver);
  Strain where(*strain.grid);
  mark_known(where, rate);
  for (int n = 1; n < kFlowSolves; ++n) {
    const TensorField factors = flow_factors(push.strain_after(velocity), where, options, dt);
    if (!factors.any()) break;
    velocity = before;
    const DiffusionReport again = push.act(velocity, factors, solver);
    report.iterations += again.iterations;
    report.residual = again.residual;
    report.memory = std::max(report.memory, again.memory);
  }
  for (int a = 0; a < 3; ++a)  // what relaxes all stress within a step is no velocity to go on with
    for (Slot s = 0; s < liquid.grid->size(); ++s)
      if (!rate.held(a, s) && !touches(liquid, a, s)) velocity.u[a][s] = before.u[a][s];
  report.memory += shares.memory();
  return report;
}

void stretch(Strain& strain, const MacVelocity& velocity, const Liquid& liquid,
             const SolidFaces& solids, const ElasticOptions& options, double dt) {
  check(options, dt);
  if (!strain.any() || dt == 0) return;
  const Shares shares = liquid_shares(liquid);
  const StrainRate rate(shares, solids, options.no_slip);
  const double h = rate.grid().h();
  const Memory memory(options, dt);
  TensorField so_far;  // as a strain rate times h
  so_far.fill(rate.grid().size(), 0);
  rate.for_each([&](const RateStencil&, int c, Slot s) {
    so_far.part(c)[s] = h * memory.kept / memory.time * strain.elastic.part(c)[s];
  });
  MacVelocity filled = velocity;
  relax_massless(filled, rate, {1, &so_far, nullptr, &liquid});
  strain.elastic.fill(rate.grid().size(), 0);
  rate.for_each([&](const RateStencil& r, int c, Slot s) {
    strain.elastic.part(c)[s] =
        memory.time / h * (so_far.part(c)[s] + rate.value(r, filled) / twice(c));
  });
  mark_known(strain, rate);
  flow(strain, flow_factors(strain.elastic, strain, options, dt));
}

double elastic_energy(const Strain& strain, const Liquid& liquid, const SolidFaces& solids,
                      const ElasticOptions& options) {
  if (!strain.any()) return 0;
  const Shares shares = liquid_shares(liquid);
  const StrainRate rate(shares, solids, options.no_slip);
  double sum = 0;
  rate.for_each([&](const RateStencil& r, int c, Slot s) {
    sum += r.weight * twice(c) * std::pow(strain.elastic.part(c)[s], 2);
  });
  return options.modulus * sum * std::pow(rate.grid().h(), 3);
}

}  // namespace suture
