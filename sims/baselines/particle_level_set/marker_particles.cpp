// Seeding, attraction, motion and re-seeding of markers.
#include "sims/baselines/particle_level_set/marker_particles.h"

#include <algorithm>
#include <optional>

#include "kernel/errors.h"

namespace suture::sims {
namespace {

double radius_at(double depth, const MarkerRules& rules) {
  return std::clamp(depth, rules.smallest_radius, rules.largest_radius);
}

/// Whether a corner of the cell lies on each side, at most the band's width from the surface.
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

/// Attracts a seed along the normal to a random level in the band of its side, unless it is in it
/// already; no marker if it has not come there after all steps.
std::optional<Marker> attract(Marker seed, const DenseLevelSet& set, const MarkerRules& rules,
                              Random& random) {
  const auto depth = [&] { return seed.side * set.sample(seed.position); };
  const auto in_band = [&](double d) { return d >= rules.smallest_radius && d <= rules.band; };
  double now = depth();
  if (!in_band(now)) {
    const double goal = random.uniform(rules.smallest_radius, rules.band);
    for (int i = 0; i < rules.attraction_steps && !in_band(now); ++i) {
      const Point from = seed.position;
      const Point way = seed.side * (goal - now) * set.normal(from);
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
  seed.radius = radius_at(now, rules);
  return seed;
}

/// The markers of one cell that stay, in their order.
void keep(const std::vector<Marker>& all, const std::vector<std::uint32_t>& of_cell,
          const Near& near, const DenseLevelSet& set, const MarkerRules& rules,
          std::vector<Marker>& kept) {
  std::vector<std::pair<double, std::uint32_t>> candidates[2];
  std::vector<std::uint32_t> stay;
  for (const std::uint32_t m : of_cell) {
    const double phi = set.sample(all[m].position);
    if (escaped(all[m], phi, rules))
      stay.push_back(m);
    else if (near.on(all[m].side))
      candidates[all[m].side < 0].emplace_back(all[m].side * phi - all[m].radius, m);
  }
  for (auto& side : candidates) {
    if (const auto most = static_cast<std::size_t>(rules.per_cell); side.size() > most) {
      std::nth_element(side.begin(), side.begin() + static_cast<std::ptrdiff_t>(most), side.end());
      side.resize(most);
    }
    for (const auto& [depth, m] : side) stay.push_back(m);
  }
  std::sort(stay.begin(), stay.end());
  for (const std::uint32_t m : stay) kept.push_back(all[m]);
}

/// Adds to the cell what it lacks; the last `has` of `markers` are in it already. Sides are added
/// in the ratio that is there, evenly to an empty cell, as in PhysBAM.
void add(std::vector<Marker>& markers, std::size_t has, const Index3& cell, const Near& near,
         const DenseLevelSet& set, const MarkerRules& rules, Random& random) {
  if (has >= static_cast<std::size_t>(rules.per_cell)) return;
  const auto inside = static_cast<std::size_t>(
      std::count_if(markers.end() - static_cast<std::ptrdiff_t>(has), markers.end(),
                    [](const Marker& m) { return m.side < 0; }));
  const std::size_t lacks = static_cast<std::size_t>(rules.per_cell) - has;
  std::size_t inner = has > 0 ? lacks * inside / has : (lacks + 1) / 2;
  if (!near.outside) inner = lacks;
  if (!near.inside) inner = 0;
  for (std::size_t i = 0; i < lacks; ++i) {
    Marker seed{Point::Zero(), 0, i < inner ? -1.0 : 1.0};
    for (int a = 0; a < 3; ++a) seed.position[a] = cell[a] + random.uniform();
    if (const auto marker = attract(seed, set, rules, random)) markers.push_back(*marker);
  }
}

}  // namespace

void adjust_radii(std::vector<Marker>& markers, const DenseLevelSet& set,
                  const MarkerRules& rules) {
  for (Marker& m : markers) m.radius = radius_at(m.side * set.sample(m.position), rules);
}

void carry(std::vector<Marker>& markers, const GridVelocity& u, double t, double dt, int order) {
  for (Marker& m : markers) {
    m.position = path_end(u, m.position, t, dt, order);
    if (!m.position.allFinite())
      throw InvalidInput("particle level set: the velocity carries a particle to nowhere at time " +
                         number(t) + "; give one that is finite everywhere");
  }
}

void reseed(std::vector<Marker>& markers, const DenseLevelSet& set, const MarkerRules& rules,
            Random& random) {
  const NodeBox& box = set.box;
  std::vector<std::uint32_t> first(box.count() + 1, 0), order(markers.size());
  const auto cell_of = [&](const Marker& m) {
    return box.at({static_cast<int>(std::floor(m.position[0])),
                   static_cast<int>(std::floor(m.position[1])),
                   static_cast<int>(std::floor(m.position[2]))});
  };
  for (const Marker& m : markers) ++first[cell_of(m) + 1];
  for (std::size_t c = 0; c < box.count(); ++c) first[c + 1] += first[c];
  std::vector<std::uint32_t> next(first.begin(), first.end() - 1);
  for (std::size_t m = 0; m < markers.size(); ++m)
    order[next[cell_of(markers[m])]++] = static_cast<std::uint32_t>(m);

  std::vector<Marker> all;
  std::vector<std::uint32_t> of_cell;
  for (int i = 0; i + 1 < box.size[0]; ++i)
    for (int j = 0; j + 1 < box.size[1]; ++j)
      for (int k = 0; k + 1 < box.size[2]; ++k) {
        const Index3 cell{box.low[0] + i, box.low[1] + j, box.low[2] + k};
        const std::size_t c = box.at(cell);
        const Near near = near_surface(set, c, rules.band);
        if (first[c] == first[c + 1] && !near.inside && !near.outside) continue;
        of_cell.assign(order.begin() + first[c], order.begin() + first[c + 1]);
        const std::size_t before = all.size();
        keep(markers, of_cell, near, set, rules, all);
        if (near.inside || near.outside)
          add(all, all.size() - before, cell, near, set, rules, random);
      }
  markers = std::move(all);
}

}  // namespace suture::sims
