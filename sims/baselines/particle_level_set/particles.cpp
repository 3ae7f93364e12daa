// Seeding, attraction, motion and re-seeding of particles.
#include "sims/baselines/particle_level_set/particles.h"

#include <algorithm>
#include <optional>

#include "kernel/errors.h"

namespace suture::sims {
namespace {

double radius_at(double depth, const ParticleRules& rules) {
  return std::clamp(depth, rules.smallest_radius, rules.largest_radius);
}

/// The sides on which a corner of the cell lies, at most the band's width from the surface.
struct Near {
  bool inside = false, outside = false;
  bool on(double side) const { return side < 0 ? inside : outside; }
};
Near near_surface(const DenseLevelSet& set, std::size_t cell, double band) {
  Near near;
  for (int corner = 0; corner < 8; ++corner) {
    const double phi =
        set.phi[cell + (corner & 4 ? set.box.stride(0) : 0) + (corner & 2 ? set.box.stride(1) : 0) +
                (corner & 1 ? set.box.stride(2) : 0)];
    if (std::abs(phi) <= band) (phi < 0 ? near.inside : near.outside) = true;
  }
  return near;
}

/// One re-seeding, from the particles before to those after.
class Reseeding {
 public:
  Reseeding(const std::vector<Particle>& before, const DenseLevelSet& set,
            const ParticleRules& rules, Random& random)
      : before_(before), set_(set), rules_(rules), random_(random) {}

  /// Goes through the cells in their order; \return the particles.
  std::vector<Particle> run() {
    const NodeBox& box = set_.box;
    sort_into_cells();
    for (int i = 0; i + 1 < box.size[0]; ++i)
      for (int j = 0; j + 1 < box.size[1]; ++j)
        for (int k = 0; k + 1 < box.size[2]; ++k)
          reseed_cell({box.low[0] + i, box.low[1] + j, box.low[2] + k});
    return std::move(after_);
  }

 private:
  std::size_t cell_of(const Particle& m) const {
    return set_.box.at({static_cast<int>(std::floor(m.position[0])),
                        static_cast<int>(std::floor(m.position[1])),
                        static_cast<int>(std::floor(m.position[2]))});
  }

  void sort_into_cells() {
    first_.assign(set_.box.count() + 1, 0);
    order_.resize(before_.size());
    for (const Particle& m : before_) ++first_[cell_of(m) + 1];
    for (std::size_t c = 0; c < set_.box.count(); ++c) first_[c + 1] += first_[c];
    std::vector<std::uint32_t> next(first_.begin(), first_.end() - 1);
    for (std::size_t m = 0; m < before_.size(); ++m)
      order_[next[cell_of(before_[m])]++] = static_cast<std::uint32_t>(m);
  }

  void reseed_cell(const Index3& cell) {
    const std::size_t c = set_.box.at(cell);
    const Near near = near_surface(set_, c, rules_.band);
    if (first_[c] == first_[c + 1] && !near.inside && !near.outside) return;
    const std::size_t others = after_.size();
    keep(c, near);
    if (near.inside || near.outside) add(cell, after_.size() - others, near);
  }

  /// Keeps the particles of the cell that stay, in their order.
  void keep(std::size_t cell, const Near& near) {
    std::vector<std::pair<double, std::uint32_t>> candidates[2];
    std::vector<std::uint32_t> stay;
    for (std::uint32_t at = first_[cell]; at < first_[cell + 1]; ++at) {
      const Particle& particle = before_[order_[at]];
      const double phi = set_.sample(particle.position);
      if (escaped(particle, phi, rules_))
        stay.push_back(order_[at]);
      else if (near.on(particle.side))
        candidates[particle.side < 0].emplace_back(particle.side * phi - particle.radius,
                                                   order_[at]);
    }
    for (auto& side : candidates) {
      if (const auto most = static_cast<std::size_t>(rules_.per_cell); side.size() > most) {
        std::nth_element(side.begin(), side.begin() + static_cast<std::ptrdiff_t>(most),
                         side.end());
        side.resize(most);
      }
      for (const auto& [depth, m] : side) stay.push_back(m);
    }
    std::sort(stay.begin(), stay.end());
    for (const std::uint32_t m : stay) after_.push_back(before_[m]);
  }

  /// Adds to the cell what it lacks; the last `has` particles are in it already. Sides are added in
  /// the ratio that is there, evenly to an empty cell, as in PhysBAM.
  void add(const Index3& cell, std::size_t has, const Near& near) {
    if (has >= static_cast<std::size_t>(rules_.per_cell)) return;
    const auto inside = static_cast<std::size_t>(
        std::count_if(after_.end() - static_cast<std::ptrdiff_t>(has), after_.end(),
                      [](const Particle& m) { return m.side < 0; }));
    const std::size_t lacks = static_cast<std::size_t>(rules_.per_cell) - has;
    std::size_t inner = has > 0 ? lacks * inside / has : (lacks + 1) / 2;
    if (!near.outside) inner = lacks;
    if (!near.inside) inner = 0;
    for (std::size_t i = 0; i < lacks; ++i) {
      Particle seed{Point::Zero(), 0, i < inner ? -1.0 : 1.0};
      for (int a = 0; a < 3; ++a) seed.position[a] = cell[a] + random_.uniform();
      if (const auto particle = attracted(seed)) after_.push_back(*particle);
    }
  }

  /// Attracts a seed along the normal to a random level in the band of its side, unless it is in it
  /// already; no particle if it has not come there after all steps.
  std::optional<Particle> attracted(Particle seed) {
    const auto depth = [&] { return seed.side * set_.sample(seed.position); };
    const auto in_band = [&](double d) { return d >= rules_.smallest_radius && d <= rules_.band; };
    double now = depth();
    if (!in_band(now)) {
      const double goal = random_.uniform(rules_.smallest_radius, rules_.band);
      for (int i = 0; i < rules_.attraction_steps && !in_band(now); ++i) {
        const Point from = seed.position;
        const Point way = seed.side * (goal - now) * set_.normal(from);
        seed.position = from + way;
        if (const double there = depth(); in_band(there)) {
          now = there;
          continue;
        }
        // Half the way then, and on from there wherever it is, as in PhysBAM.
        seed.position = from + 0.5 * way;
        now = depth();
      }
      if (!in_band(now)) return std::nullopt;
    }
    seed.radius = radius_at(now, rules_);
    return seed;
  }

  const std::vector<Particle>& before_;
  const DenseLevelSet& set_;
  const ParticleRules& rules_;
  Random& random_;
  std::vector<std::uint32_t> first_, order_;  ///< of each cell the first place in `order_`
  std::vector<Particle> after_;
};

}  // namespace

void adjust_radii(std::vector<Particle>& particles, const DenseLevelSet& set,
                  const ParticleRules& rules) {
  for (Particle& m : particles) m.radius = radius_at(m.side * set.sample(m.position), rules);
}

void carry(std::vector<Particle>& particles, const GridVelocity& u, const PathStep& step) {
  for (Particle& m : particles) {
    m.position = path_end(u, m.position, step);
    if (!m.position.allFinite())
      throw InvalidInput("particle level set: the velocity carries a particle to nowhere at time " +
                         number(step.time) + "; give one that is finite everywhere");
  }
}

void reseed(std::vector<Particle>& particles, const DenseLevelSet& set, const ParticleRules& rules,
            Random& random) {
  std::vector<Particle> after = Reseeding(particles, set, rules, random).run();
  particles = std::move(after);
}

}  // namespace suture::sims
