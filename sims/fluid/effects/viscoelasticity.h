// Elasticity of the liquid: it strains, springs back, yields and forgets.
#pragma once

#include <limits>
#include <memory>

#include "kernel/option_table.h"
#include "sims/fluid/effects/stress/strain.h"
#include "sims/fluid/effects/viscosity.h"

namespace suture::sims {

struct ElasticOptions {
  double modulus = 0;  ///< G, of shear: stress is 2G·(elastic strain)
  double density = 1;
  /// Size of the deviatoric elastic strain (root of the sum of its nine squares) beyond which it
  /// flows, and the rate, per time, at which what is beyond decays. Infinite: at once.
  double yield_strain = std::numeric_limits<double>::infinity();
  double flow_rate = std::numeric_limits<double>::infinity();
  /// The time in which strain decays to 1/e. Where it is short against a step the liquid is
  /// viscous, with viscosity modulus·relaxation_time.
  double relaxation_time = std::numeric_limits<double>::infinity();
  bool no_slip = true;  ///< at solids

  WallSlip slip() const { return no_slip ? WallSlip::none : WallSlip::free; }
};

/// [fluid.viscoelasticity]; the density is the liquid's.
const OptionTable<ElasticOptions>& viscoelasticity_options();

/// Steps beyond the time in which a wave of shear crosses a cell do not resolve it, and damp what
/// they do not resolve; no step is unstable. Infinite where modulus is 0.
double largest_step(const ElasticOptions& options, double h);

/// A liquid's strain before it has any; empty, without arrays, where modulus is 0.
/// \throw InvalidInput for numbers out of range
Strain unstrained(const SharedGrid& grid, const ElasticOptions& options);

/// Adds what elastic stress does to the velocity in dt [Goktekin et al. 2004], before the
/// projection. Implicit: the stress is that of the strain at the step's end, which is a viscosity
/// modulus·dt and the stress of the strain so far; within largest_step, that of the strain half a
/// step on, as good as without damping. Faces that touch no liquid cell are left: no projection
/// gives them a velocity, so that they follow without mass. The report's status is the worse of its
/// two solves'. \pre, \throw, accuracy as diffuse
DiffusionReport push(MacVelocity& velocity, const Strain& strain, const FlowDomain& domain,
                     const ElasticOptions& options, const ImplicitStep& step);

/// Adds what the velocity after the projection strains in dt; then what yields flows, and what
/// relaxes is forgotten. Reports the solve for the faces without mass.
/// \pre velocity is known on all faces that have liquid
SolveReport stretch(Strain& strain, const MacVelocity& velocity, const FlowDomain& domain,
                    const ElasticOptions& options, double dt);

/// The energy of the strain: modulus times its square, over the liquid.
double elastic_energy(const Strain& strain, const FlowDomain& domain,
                      const ElasticOptions& options);

/// \pre the options are in the ranges of their table
std::unique_ptr<Effect> make_viscoelasticity(const ElasticOptions& options,
                                             const SolverOptions& solver,
                                             const ModuleAccount& account);

}  // namespace suture::sims
