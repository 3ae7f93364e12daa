// Elasticity of the liquid: it strains, springs back, yields and forgets.
#include "sims/fluid/effects/viscoelasticity.h"

#include <algorithm>
#include <cmath>

#include "kernel/errors.h"

namespace suture::sims {
namespace {

void check(const ElasticOptions& o, double dt) {
  const auto refuse = [](const char* what, double x) {
    throw InvalidInput(std::string("elasticity: ") + what + ", not " + number(x));
  };
  check(o, viscoelasticity_options(), "elasticity: ");
  if (!(o.density > 0) || !std::isfinite(o.density))
    refuse("density must be finite and above 0", o.density);
  if (!(dt >= 0) || !std::isfinite(dt)) refuse("a step must be finite and at least 0", dt);
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

/// The solves of a step in which liquid flows. Each takes the stress that flow leaves of what
/// velocity strains: that before the step for the first one, and that of the one before for the
/// others.
constexpr int kFlowSolves = 2;

/// A shear's stencil makes twice its component.
double twice(int component) { return component < 3 ? 1 : 2; }

/// How a strain flows in dt.
struct Flow {
  const ElasticOptions& options;
  double dt;

  bool any() const { return std::isfinite(options.yield_strain); }
  /// The part that is left of a strain of this size.
  double left(double size) const {
    const double yield = options.yield_strain;
    if (!(size > yield)) return 1;
    return (yield + (size - yield) * std::exp(-options.flow_rate * dt)) / size;
  }
};

/// The deviatoric strain's size at a cell's middle: of shears, the mean at its edges.
double deviatoric_size(const TensorField& t, const Strain& where, Slot s) {
  const double mean = (t.stretch[0][s] + t.stretch[1][s] + t.stretch[2][s]) / 3;
  double sum = 0;
  for (int a = 0; a < 3; ++a) {
    sum += std::pow(t.stretch[a][s] - mean, 2);
    double squares = 0;
    int count = 0;
    for (const Slot edge : edges_of_cell(*where.grid, a, s)) {
      if (where.known[1 + a][edge] == 0) continue;
      squares += t.shear[a][edge] * t.shear[a][edge];
      ++count;
    }
    if (count != 0) sum += 2 * squares / count;
  }
  return std::sqrt(sum);
}

std::vector<double> deviatoric_sizes(const TensorField& t, const Strain& where) {
  std::vector<double> sizes(where.grid->size(), 0);
  for (Slot s = 0; s < sizes.size(); ++s)
    if (where.known[0][s] != 0) sizes[s] = deviatoric_size(t, where, s);
  return sizes;
}

/// How a shear's factor follows from those of the cells round it.
enum class OfCells { mean, least };

/// Factors of all components from those of cells.
TensorField spread(const std::vector<double>& of_cells, const Strain& where, OfCells taken) {
  TensorField factors;
  factors.fill(of_cells.size(), 1);
  for (Slot s = 0; s < of_cells.size(); ++s)
    for (int a = 0; a < 3; ++a) {
      factors.stretch[a][s] = of_cells[s];
      if (where.known[1 + a][s] == 0) continue;
      double sum = 0, smallest = 1;
      int count = 0;
      for (const Slot cell : cells_round_edge(*where.grid, a, s)) {
        if (where.known[0][cell] == 0) continue;
        sum += of_cells[cell];
        smallest = std::min(smallest, of_cells[cell]);
        ++count;
      }
      if (count != 0) factors.shear[a][s] = taken == OfCells::least ? smallest : sum / count;
    }
  return factors;
}

/// The part that flow leaves of each component. There are no arrays where nothing flows.
TensorField flow_factors(const TensorField& t, const Strain& where, const Flow& flow) {
  if (!flow.any()) return {};
  std::vector<double> left = deviatoric_sizes(t, where);
  bool any = false;
  for (double& x : left) {
    x = flow.left(x);
    any = any || x != 1;
  }
  return any ? spread(left, where, OfCells::mean) : TensorField();
}

/// Multiplies the deviatoric part by the factors.
void scale(TensorField& t, const TensorField& factors) {
  for (Slot s = 0; s < t.stretch[0].size(); ++s) {
    const double mean = (t.stretch[0][s] + t.stretch[1][s] + t.stretch[2][s]) / 3;
    for (int a = 0; a < 3; ++a) {
      t.stretch[a][s] = mean + factors.stretch[a][s] * (t.stretch[a][s] - mean);
      t.shear[a][s] *= factors.shear[a][s];
    }
  }
}

/// Means leave the shears of strains that change from cell to cell too large for some of these;
/// what is still too much there goes by the least factor. By that alone, all would flow too easily.
void yield(Strain& strain, const Flow& flow) {
  const TensorField factors = flow_factors(strain.elastic, strain, flow);
  if (!factors.any()) return;
  const std::vector<double> before = deviatoric_sizes(strain.elastic, strain);
  scale(strain.elastic, factors);
  std::vector<double> rest = deviatoric_sizes(strain.elastic, strain);
  for (Slot s = 0; s < rest.size(); ++s) {
    const double wanted = before[s] * flow.left(before[s]);
    rest[s] = rest[s] > wanted ? wanted / rest[s] : 1;
  }
  scale(strain.elastic, spread(rest, strain, OfCells::least));
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

/// The numbers of a step of the stress.
struct ElasticStep {
  Memory memory;
  double squared;  ///< cells that a wave of shear crosses in the step, squared
  Weights weights;
  double stiffness, per_rate;

  ElasticStep(const ElasticOptions& o, double h, double dt)
      : memory(o, dt),
        squared(o.modulus / o.density / h * (dt / h) * memory.time),
        weights(std::sqrt(squared), memory.kept),
        stiffness(std::min(squared * weights.end, kStiffest)),
        per_rate(memory.time * weights.end / h) {}

  /// The strain so far and the step's first rate, as a strain rate times h.
  TensorField offset(const StrainRate& rate, const MacVelocity& before,
                     const Strain& strain) const {
    TensorField t;
    t.fill(rate.grid().size(), 0);
    rate.for_each([&](const RateStencil& r, int c, Slot s) {
      const double begin = rate.value(r, before) / twice(c);
      t.part(c)[s] =
          memory.kept / per_rate * strain.elastic.part(c)[s] - weights.begin / weights.end * begin;
    });
    return t;
  }
};

/// One step of the stress, whatever flows in it.
struct Push {
  const ElasticStep& elastic;
  const StrainRate& rate;
  const Liquid& liquid;
  TensorField offset;

  DiffusionReport act(MacVelocity& velocity, const TensorField& factors,
                      const SolverOptions& solver) const {
    const StressStep step{elastic.stiffness, &offset, factors.any() ? &factors : nullptr, &liquid};
    DiffusionReport report = step_stress(velocity, rate, step, solver);
    report.memory += offset.memory() + factors.memory();
    return report;
  }

  /// The strain whose stress acts in the step that ends with this velocity, if nothing flows.
  TensorField strain(const MacVelocity& velocity) const {
    TensorField t = offset;
    rate.for_each([&](const RateStencil& r, int c, Slot s) {
      t.part(c)[s] = elastic.per_rate * (t.part(c)[s] + rate.value(r, velocity) / twice(c));
    });
    return t;
  }
};

void mark_known(Strain& strain, const StrainRate& rate) {
  for (auto& k : strain.known) std::fill(k.begin(), k.end(), 0);
  rate.for_each([&](const RateStencil&, int c, Slot s) { strain.known[c < 3 ? 0 : c - 2][s] = 1; });
}

/// Takes up the report of a solve that replaces the one before.
void replace(DiffusionReport& report, const DiffusionReport& again) {
  report.iterations += again.iterations;
  report.residual = again.residual;
  report.status = std::max(report.status, again.status);
  report.memory = std::max(report.memory, again.memory);
}

class Viscoelasticity final : public Effect {
 public:
  Viscoelasticity(const ElasticOptions& options, const SolverOptions& solver,
                  const ModuleAccount& account)
      : options_(options), solver_(solver), account_(account) {}

  void carry(const MacVelocity& old, const Liquid& liquid, double dt) override {
    if (!strain_.any()) return;
    account_.timed([&] { strain_ = carried(strain_, old, liquid, dt); });
  }
  void stress(const StepState& step) override {
    account_.timed([&] {
      if (strain_.grid == nullptr) strain_ = unstrained(step.domain.liquid.grid, options_);
      const DiffusionReport done =
          push(step.velocity, strain_, step.domain, options_, {step.dt, solver_});
      account_.solved(done);
      account_.holds(strain_.memory() + done.memory);
    });
  }
  void flowed(const StepState& step) override {
    if (!strain_.any()) return;
    account_.timed(
        [&] { account_.checked(stretch(strain_, step.velocity, step.domain, options_, step.dt)); });
  }

 private:
  ElasticOptions options_;
  SolverOptions solver_;
  ModuleAccount account_;
  Strain strain_;  ///< empty before the first step
};

}  // namespace

double largest_step(const ElasticOptions& options, double h) {
  return h * std::sqrt(options.density / options.modulus);
}

Strain unstrained(const SharedGrid& grid, const ElasticOptions& options) {
  check(options, 0);
  return options.modulus > 0 ? Strain(grid) : Strain();
}

DiffusionReport push(MacVelocity& velocity, const Strain& strain, const FlowDomain& domain,
                     const ElasticOptions& options, const ImplicitStep& step) {
  check(options, step.dt);
  if (!strain.any() || step.dt == 0) return {};
  const Liquid& liquid = domain.liquid;
  const VolumeFractions fractions = volume_fractions(liquid);
  const StrainRate rate(fractions, domain.solids, options.slip());
  const MacVelocity before = velocity;
  const ElasticStep elastic(options, rate.grid().h(), step.dt);
  const Push push{elastic, rate, liquid, elastic.offset(rate, before, strain)};
  Strain where(strain.grid);
  mark_known(where, rate);
  DiffusionReport report;
  bool flowed_before = true;
  for (int n = 0; n < kFlowSolves; ++n) {
    const TensorField factors = flow_factors(push.strain(velocity), where, {options, step.dt});
    if (!factors.any() && !flowed_before) break;
    flowed_before = factors.any();
    velocity = before;
    replace(report, push.act(velocity, factors, step.solver));
  }
  for (int a = 0; a < 3; ++a)  // what relaxes all stress within a step is no velocity to go on with
    for (Slot s = 0; s < liquid.grid->size(); ++s)
      if (!rate.held(a, s) && !touches(liquid, a, s)) velocity.u[a][s] = before.u[a][s];
  report.memory += fractions.memory() + where.memory() +
                   3 * before.u[0].size() * (sizeof(double) + sizeof(std::uint8_t));
  return report;
}

SolveReport stretch(Strain& strain, const MacVelocity& velocity, const FlowDomain& domain,
                    const ElasticOptions& options, double dt) {
  check(options, dt);
  if (!strain.any() || dt == 0) return {};
  const VolumeFractions fractions = volume_fractions(domain.liquid);
  const StrainRate rate(fractions, domain.solids, options.slip());
  const double h = rate.grid().h();
  const Memory memory(options, dt);
  TensorField so_far;  // as a strain rate times h
  so_far.fill(rate.grid().size(), 0);
  rate.for_each([&](const RateStencil&, int c, Slot s) {
    so_far.part(c)[s] = h * memory.kept / memory.time * strain.elastic.part(c)[s];
  });
  MacVelocity filled = velocity;
  const SolveReport report = relax_massless(filled, rate, {1, &so_far, nullptr, &domain.liquid});
  strain.elastic.fill(rate.grid().size(), 0);
  rate.for_each([&](const RateStencil& r, int c, Slot s) {
    strain.elastic.part(c)[s] =
        memory.time / h * (so_far.part(c)[s] + rate.value(r, filled) / twice(c));
  });
  mark_known(strain, rate);
  yield(strain, {options, dt});
  return report;
}

double elastic_energy(const Strain& strain, const FlowDomain& domain,
                      const ElasticOptions& options) {
  if (!strain.any()) return 0;
  const VolumeFractions fractions = volume_fractions(domain.liquid);
  const StrainRate rate(fractions, domain.solids, options.slip());
  double sum = 0;
  rate.for_each([&](const RateStencil& r, int c, Slot s) {
    sum += r.weight * twice(c) * std::pow(strain.elastic.part(c)[s], 2);
  });
  return options.modulus * sum * std::pow(rate.grid().h(), 3);
}

std::unique_ptr<Effect> make_viscoelasticity(const ElasticOptions& options,
                                             const SolverOptions& solver,
                                             const ModuleAccount& account) {
  return std::make_unique<Viscoelasticity>(options, solver, account);
}

}  // namespace suture::sims
