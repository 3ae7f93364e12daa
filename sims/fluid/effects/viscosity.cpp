// Viscosity of the liquid, from none to that of a rigid body.
#include "sims/fluid/effects/viscosity.h"

#include <algorithm>
#include <cmath>

#include "kernel/errors.h"

namespace suture::sims {
namespace {

void check(const ViscosityOptions& o, double dt) {
  const auto refuse = [](const char* what, double x) {
    throw InvalidInput(std::string(what) + ", not " + number(x));
  };
  if (!(o.viscosity >= 0) || !std::isfinite(o.viscosity))
    refuse("viscosity must be finite and at least 0", o.viscosity);
  if (!(o.density > 0) || !std::isfinite(o.density))
    refuse("density must be finite and above 0", o.density);
  if (!(dt >= 0) || !std::isfinite(dt)) refuse("a step must be finite and at least 0", dt);
}

class Viscosity final : public Effect {
 public:
  Viscosity(const ViscosityOptions& options, const SolverOptions& solver,
            const ModuleAccount& account)
      : options_(options), solver_(solver), account_(account) {}

  void stress(const StepState& step) override {
    account_.timed([&] {
      const DiffusionReport done =
          diffuse(step.velocity, step.domain, options_, {step.dt, solver_});
      account_.solved(done);
      account_.holds(done.memory);
    });
  }

 private:
  ViscosityOptions options_;
  SolverOptions solver_;
  ModuleAccount account_;
};

}  // namespace

DiffusionReport diffuse(MacVelocity& velocity, const FlowDomain& domain,
                        const ViscosityOptions& viscosity, const ImplicitStep& step) {
  const double dt = step.dt;
  check(viscosity, dt);
  if (viscosity.viscosity == 0 || dt == 0) return {};
  const double h = domain.liquid.grid->h();
  StressStep stress;  // in an order that neither overflows nor loses what is tiny, at any unit
  stress.stiffness = std::min(viscosity.viscosity / viscosity.density / h * (dt / h), kStiffest);
  const VolumeFractions fractions = volume_fractions(domain.liquid);
  const StrainRate rate(fractions, domain.solids, viscosity.slip());
  DiffusionReport report = step_stress(velocity, rate, stress, step.solver);
  report.memory += fractions.memory();
  return report;
}

std::unique_ptr<Effect> make_viscosity(const ViscosityOptions& options, const SolverOptions& solver,
                                       const ModuleAccount& account) {
  return std::make_unique<Viscosity>(options, solver, account);
}

}  // namespace suture::sims
