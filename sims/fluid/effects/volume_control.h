// Volume control: each body of liquid is given the divergence that brings back what it has lost.
#pragma once

#include <memory>
#include <vector>

#include "kernel/option_table.h"
#include "sims/fluid/effects/effect.h"
#include "sims/fluid/liquid/liquid_bodies.h"

namespace suture::sims {

/// How fast lost volume comes back [Kim et al. 2007]. Who loses a part of the volume in every step
/// is short of `relaxation` times that, less what the integral part balances.
struct VolumeControlOptions {
  /// Steps in which an error falls to 1/e; above 2, or the flow, which answers a step late, swings.
  double relaxation = 10;
  /// The damping of the loop with its integral part, whose gain is 1/(4·damping²) of the other's
  /// over a relaxation: at 2 an error swings back by a thirteenth of itself, above that by less.
  double damping = 2;
  /// Cells: the most that control moves a body's surface in a step, well below what the flow may.
  double most_shift = 0.1;
  /// The relative error that the integral part counts as at most, so that it cannot wind up where
  /// volume is out of reach; so the most that it balances is such a loss in every relaxation.
  double most_integral = 0.02;
};

/// [fluid.volume_control].
const OptionTable<VolumeControlOptions>& volume_control_options();

/// Knows the volume that each body should have, and hands it on when bodies merge and split: call
/// before_remodel and after_remodel round all that changes triangles, and moved after each
/// advection.
class VolumeControl {
 public:
  /// The bodies should have the volumes that they have. \pre closed, oriented outwards
  /// \throw InvalidInput if an option is out of its range
  explicit VolumeControl(const Triangles& surface, const VolumeControlOptions& options = {});

  /// The surface has moved: the same triangles, other positions. \throw InvalidInput if their
  /// number has changed, or a remodel has begun
  void moved(const Triangles& surface);

  void before_remodel(const Triangles& surface);
  /// Each group of bodies that hold the same liquid before and after (track_components) keeps the
  /// sum of its targets, to rounding, shared out by the volumes that they have now. What became of
  /// nothing hands its target to the largest body's group, where it is felt least, and what comes
  /// from nothing has its own from there: the sum over all stays, while there is a body. `move`:
  /// where a point of the surface before is now, if all has moved since. \throw InvalidInput if no
  /// remodel has begun
  void after_remodel(const Triangles& surface, const SurfacePath& move = nullptr);

  /// The divergence wanted in each cell for a step dt, for ProjectionInput::divergence; none in
  /// bodies smaller than a cell. Adds to the integral parts: once a step, after moved.
  /// \pre nearest and liquid are of the surface last told \throw InvalidInput unless dt is positive
  std::vector<double> divergence(const NearestTriangle& nearest, const Liquid& liquid, double dt);

  struct Body {
    double target = 0, volume = 0, area = 0;
    double integral = 0;  ///< of the relative error, over time in relaxations
  };
  const std::vector<Body>& bodies() const { return bodies_; }
  std::size_t memory() const;

 private:
  double rate(Body& body, double h, double dt) const;

  VolumeControlOptions options_;
  LiquidBodies parts_;  ///< of the surface last told
  std::vector<Body> bodies_;
  Triangles before_;  ///< while a remodel goes on
  bool remodelling_ = false;
};

/// \pre the options are in the ranges of their table
std::unique_ptr<Effect> make_volume_control(const VolumeControlOptions& options,
                                            const ModuleAccount& account);

}  // namespace suture::sims
