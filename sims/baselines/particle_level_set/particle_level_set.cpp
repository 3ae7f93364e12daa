// The order of a particle level set's step, behind the interface of all trackers.
#include "sims/baselines/particle_level_set/particle_level_set.h"

#include <optional>

#include "kernel/audit.h"
#include "kernel/errors.h"
#include "sims/baselines/grid/level_set_surface.h"
#include "sims/baselines/particle_level_set/fast_marching.h"
#include "sims/baselines/particle_level_set/particle_correction.h"
#include "sims/baselines/particle_level_set/semi_lagrangian.h"
#include "sims/baselines/particle_level_set/weno_level_set.h"
#include "sims/support/clock.h"

namespace suture::sims {
namespace {

void check(const ParticleLevelSetOptions& o) {
  check(o, particle_level_set_options(), "particle level set: ");
  if (!(o.smallest_radius <= o.largest_radius && o.largest_radius <= o.band))
    throw InvalidInput(
        "particle level set: radii are in cells: 0 < smallest_radius <= largest_radius <= band");
}

ParticleRules rules_of(const ParticleLevelSetOptions& o) {
  return {o.particles_per_cell, o.band,   o.smallest_radius,
          o.largest_radius,     o.escape, o.attraction_steps};
}

/// Cells of band beyond the particles: the normal at one takes a cell, interpolation one more.
constexpr double kBeyondBand = 2;

class ParticleLevelSet : public SurfaceTracker {
 public:
  ParticleLevelSet(const Triangles& surface, const ParticleLevelSetOptions& options)
      : options_(options),
        rules_(rules_of(options)),
        frame_{options.cell_size, options.origin},
        random_(options.seed),
        set_(dense_level_set(surface, frame_, options.band + kBeyondBand)) {
    if (rules_.per_cell > 0) reseed(particles_, set_, rules_, random_);
  }

  void advect(const VelocityField& u, double dt) override {
    const GridVelocity velocity{u, frame_.origin, frame_.cell_size};
    std::vector<Particle> particles = particles_;
    costs_.timed("particles", [&] {
      carry(particles, velocity, {time_, dt, options_.particle_order});
    });
    costs_.timed("level_set", [&] {
      set_ = weno() ? weno_advected(set_, velocity, {time_, dt, around(particles)})
                    : semi_lagrangian(set_, velocity,
                                      {{time_, dt, options_.trace_order}, around(particles)});
    });
    particles_ = std::move(particles);
    surface_.reset();
    time_ += dt;
    ++steps_;
    correct_by_particles();
    distances_ = false;
    if (options_.reinitialise_every > 0 && steps_ % options_.reinitialise_every == 0)
      reinitialise();
    costs_.timed("particles", [&] { adjust_radii(particles_, set_, rules_); });
    if (options_.reseed_every > 0 && steps_ % options_.reseed_every == 0 && rules_.per_cell > 0)
      costs_.timed("reseed", [&] { reseed(particles_, set_, rules_, random_); });
  }

  /// Re-initialises; re-seeding does not change the surface and stays in its rhythm.
  void end_of_frame() override {
    if (distances_ || options_.reinitialise_every == 0) return;
    surface_.reset();
    reinitialise();
    costs_.timed("particles", [&] { adjust_radii(particles_, set_, rules_); });
  }

  const Triangles& surface() override {
    if (!surface_) costs_.timed("contour", [&] { surface_ = zero_surface(set_, frame_); });
    return *surface_;
  }

  double distance(const Point& p) override {
    return frame_.cell_size * set_.sample(frame_.cells(p));
  }

  double time() const override { return time_; }

  TrackerCost cost() const override {
    return {costs_.seconds,
            {{"particles", static_cast<double>(particles_.size())},
             {"escaped", escaped_},
             {"nodes", static_cast<double>(set_.phi.size())}}};
  }

 private:
  bool weno() const { return options_.version == ParticleLevelSetVersion::weno; }

  static Box around(const std::vector<Particle>& particles) {
    Box box{Point::Constant(1), Point::Constant(0)};
    if (!particles.empty()) box = {particles[0].position, particles[0].position};
    for (const Particle& m : particles) {
      box.low = box.low.cwiseMin(m.position);
      box.high = box.high.cwiseMax(m.position);
    }
    return box;
  }

  void correct_by_particles() {
    costs_.timed("correct",
                 [&] { escaped_ = static_cast<double>(correct(set_, particles_, rules_)); });
  }
  void reinitialise() {
    costs_.timed("reinitialise", [&] {
      if (weno())
        set_ = weno_relaxed(set_, options_.relaxation_steps, around(particles_));
      else
        march_distances(set_);
    });
    correct_by_particles();
    distances_ = true;
  }

  ParticleLevelSetOptions options_;
  ParticleRules rules_;
  GridFrame frame_;
  Random random_;
  DenseLevelSet set_;
  std::vector<Particle> particles_;
  std::optional<Triangles> surface_;
  double time_ = 0;
  std::int64_t steps_ = 0;
  bool distances_ = true;  ///< φ was re-initialised since the last step
  double escaped_ = 0;     ///< particles, at the last correction
  Costs costs_{{{"level_set", 0},
                {"particles", 0},
                {"correct", 0},
                {"reinitialise", 0},
                {"reseed", 0},
                {"contour", 0}},
               {}};
};

}  // namespace

std::unique_ptr<SurfaceTracker> make_particle_level_set(const Triangles& surface,
                                                        const ParticleLevelSetOptions& options) {
  check(options);
  require_closed_manifold(surface, "the surface of a particle level set");
  return std::make_unique<ParticleLevelSet>(surface, options);
}

}  // namespace suture::sims
