// Elasticity of the liquid: it strains, springs back, yields and forgets.
#include "sims/fluid/effects/viscoelasticity.h"

#include <algorithm>
#include <cmath>

#include "kernel/errors.h"
#include "sims/fluid/effects/viscosity.h"

namespace suture::sims {
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

/// Of a step in which liquid flows. Each solve takes the stress that flow leaves of what velocity
/// strains: that before the step for the first one, and that of the one before for the others.
constexpr int kFlowSolves = 2;

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

std::vector<double> deviatoric_sizes(const TensorField& t, const Strain& where) {
  std::vector<double> sizes(where.grid->size(), 0);
  for (Slot s = 0; s < sizes.size(); ++s)
    if (where.known[0][s] != 0) sizes[s] = deviatoric_size(t, where, s);
  return sizes;
}

/// Factors of all components from those of cells: a shear's is the mean, or the least, of those of
/// the cells round it.
TensorField spread(const std::vector<double>& of_cells, const Strain& where, bool least) {
  TensorField factors;
  factors.fill(of_cells.size(), 1);
  for (Slot s = 0; s < of_cells.size(); ++s)
    for (int a = 0; a < 3; ++a) {
      factors.stretch[a][s] = of_cells[s];
      if (where.known[1 + a][s] == 0) continue;
      double sum = 0, smallest = 1;
      int count = 0;
      for_each_cell_round(*where.grid, a, s, [&](Slot cell) {
        if (where.known[0][cell] == 0) return;
        sum += of_cells[cell];
        smallest = std::min(smallest, of_cells[cell]);
        ++count;
      });
      if (count != 0) factors.shear[a][s] = least ? smallest : sum / count;
    }
  return factors;
}

/// What flow leaves of each component in dt. Without arrays where nothing flows.
TensorField flow_factors(const TensorField& t, const Strain& where, const ElasticOptions& o,
                         double dt) {
  if (!std::isfinite(o.yield_strain)) return {};
  std::vector<double> left = deviatoric_sizes(t, where);
  bool any = false;
  for (double& x : left) {
    x = flowed(x, o, dt);
    any = any || x != 1;
  }
  return any ? spread(left, where, false) : TensorField();
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
void flow(Strain& strain, const ElasticOptions& o, double dt) {
  const TensorField factors = flow_factors(strain.elastic, strain, o, dt);
  if (!factors.any()) return;
  const std::vector<double> before = deviatoric_sizes(strain.elastic, strain);
  scale(strain.elastic, factors);
  std::vector<double> rest = deviatoric_sizes(strain.elastic, strain);
  for (Slot s = 0; s < rest.size(); ++s) {
    const double wanted = before[s] * flowed(before[s], o, dt);
    rest[s] = rest[s] > wanted ? wanted / rest[s] : 1;
  }
  scale(strain.elastic, spread(rest, strain, true));
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

/// One step of the stress.
class Push {
 public:
  Push(const MacVelocity& before, const Strain& strain, const Liquid& liquid,
       const StrainRate& rate, const ElasticOptions& o, double dt)
      : liquid_(liquid), rate_(rate) {
    const double h = rate.grid().h();
    const Memory memory(o, dt);
    const double squared = o.modulus / o.density / h * (dt / h) * memory.time;
    const Weights weights(std::sqrt(squared), memory.kept);
    stiffness_ = std::min(squared * weights.end, kStiffest);
    per_rate_ = memory.time * weights.end / h;
    offset_.fill(rate.grid().size(), 0);
    rate.for_each([&](const RateStencil& r, int c, Slot s) {
      const double begin = rate.value(r, before) / twice(c);
      offset_.part(c)[s] =
          memory.kept / per_rate_ * strain.elastic.part(c)[s] - weights.begin / weights.end * begin;
    });
  }

  DiffusionReport act(MacVelocity& velocity, const TensorField& factors,
                      const SolverOptions& solver) const {
    const StressStep step{stiffness_, &offset_, factors.any() ? &factors : nullptr, &liquid_};
    DiffusionReport report = step_stress(velocity, rate_, step, solver);
    report.memory += offset_.memory() + factors.memory();
    return report;
  }

  /// The strain whose stress acts in the step that ends with this velocity, if nothing flows.
  TensorField strain(const MacVelocity& velocity) const {
    TensorField t = offset_;
    rate_.for_each([&](const RateStencil& r, int c, Slot s) {
      t.part(c)[s] = per_rate_ * (t.part(c)[s] + rate_.value(r, velocity) / twice(c));
    });
    return t;
  }

 private:
  const Liquid& liquid_;
  const StrainRate& rate_;
  double stiffness_, per_rate_;
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
  Strain where(*strain.grid);
  mark_known(where, rate);
  DiffusionReport report;
  bool flowed_before = true;
  for (int n = 0; n < kFlowSolves; ++n) {
    const TensorField factors = flow_factors(push.strain(velocity), where, options, dt);
    if (!factors.any() && !flowed_before) break;
    flowed_before = factors.any();
    velocity = before;
    const DiffusionReport again = push.act(velocity, factors, solver);
    report.iterations += again.iterations;
    report.residual = again.residual;
    report.memory = std::max(report.memory, again.memory);
  }
  for (int a = 0; a < 3; ++a)  // what relaxes all stress within a step is no velocity to go on with
    for (Slot s = 0; s < liquid.grid->size(); ++s)
      if (!rate.held(a, s) && !touches(liquid, a, s)) velocity.u[a][s] = before.u[a][s];
  report.memory += shares.memory() + where.memory() +
                   3 * before.u[0].size() * (sizeof(double) + sizeof(std::uint8_t));
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
  flow(strain, options, dt);
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

}  // namespace suture::sims
