// Viscosity of the liquid, from none to that of a rigid body.
#include "sims/fluid/effects/viscosity.h"

#include <algorithm>
#include <cmath>

#include "kernel/errors.h"

namespace suture::sims {

DiffusionReport diffuse(MacVelocity& velocity, const Liquid& liquid, const SolidFaces& solids,
                        const ViscosityOptions& viscosity, double dt,
                        const SolverOptions& options) {
  const auto check = [](bool right, const char* what, double x) {
    if (!right) throw InvalidInput(std::string(what) + number(x));
  };
  check(viscosity.viscosity >= 0 && std::isfinite(viscosity.viscosity),
        "viscosity must be finite and at least 0, not ", viscosity.viscosity);
  check(viscosity.density > 0 && std::isfinite(viscosity.density),
        "density must be finite and above 0, not ", viscosity.density);
  check(dt >= 0 && std::isfinite(dt), "a step must be finite and at least 0, not ", dt);
  if (viscosity.viscosity == 0 || dt == 0) return {};
  const double h = liquid.grid->h();
  StressStep step;  // in an order that neither overflows nor loses what is tiny, at any unit
  step.stiffness = std::min(viscosity.viscosity / viscosity.density / h * (dt / h), kStiffest);
  const Shares shares = liquid_shares(liquid);
  const StrainRate rate(shares, solids, viscosity.no_slip);
  DiffusionReport report = step_stress(velocity, rate, step, options);
  report.memory += shares.memory();
  return report;
}

}  // namespace suture::sims
