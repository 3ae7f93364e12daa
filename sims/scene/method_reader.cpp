// The table [method] of a scene: the keys of each kind, their ranges, and their defaults.
#include <array>
#include <limits>

#include "sims/baselines/method.h"

namespace suture::sims {
namespace {

constexpr std::array<Named<MethodKind>, 6> kKinds = {
    {{"mesh", MethodKind::mesh},
     {"mesh_without_topology", MethodKind::mesh_without_topology},
     {"markers", MethodKind::markers},
     {"level_set", MethodKind::level_set},
     {"particle_level_set", MethodKind::particle_level_set},
     {"semi_lagrangian_contouring", MethodKind::semi_lagrangian_contouring}}};
constexpr std::array<Named<Advection>, 2> kAdvections = {
    {{"upwind", Advection::upwind}, {"mac_cormack", Advection::mac_cormack}}};
constexpr std::array<Named<UpwindScheme>, 4> kSchemes = {{{"first", UpwindScheme::first},
                                                          {"second", UpwindScheme::second},
                                                          {"third", UpwindScheme::third},
                                                          {"weno5", UpwindScheme::weno5}}};
constexpr std::array<Named<Limiter>, 3> kLimiters = {
    {{"clamp", Limiter::clamp}, {"revert", Limiter::revert}, {"none", Limiter::none}}};
constexpr std::array<Named<ParticleLevelSetVersion>, 2> kVersions = {
    {{"semi_lagrangian", ParticleLevelSetVersion::semi_lagrangian},
     {"weno", ParticleLevelSetVersion::weno}}};

int integer(Keys& keys, const char* key, Range allowed, int fallback) {
  return static_cast<int>(keys.integer(key, allowed, fallback));
}

Range counts() { return Range::between(0, std::numeric_limits<int>::max()); }

/// Whatever has cells and an origin.
void read_lattice(Keys& keys, const TrackerOptions& tracker, auto& options) {
  options.cell_size = keys.number("cell_size", Range::above(0), tracker.cell_size);
  options.origin = keys.vector("origin", tracker.origin);
}

void read(Keys& keys, LevelSetOptions& o) {
  o.half_width = keys.number("half_width", Range::between(1, 1000), o.half_width);
  o.advection = keys.choice("advection", kAdvections, o.advection);
  o.scheme = keys.choice("scheme", kSchemes, o.scheme);
  o.time_order = integer(keys, "time_order", Range::between(1, 3), o.time_order);
  o.trace_order = integer(keys, "trace_order", Range::between(2, 4), o.trace_order);
  o.limiter = keys.choice("limiter", kLimiters, o.limiter);
  Renormalisation& r = o.renormalise;
  r.every = integer(keys, "renormalise_every", counts(), r.every);
  r.scheme = keys.choice("renormalise_scheme", kSchemes, r.scheme);
  r.time_order = integer(keys, "renormalise_time_order", Range::between(1, 3), r.time_order);
  r.steps = integer(keys, "renormalise_steps", Range::between(1, 1000), r.steps);
}

void read(Keys& keys, ParticleLevelSetOptions& o) {
  o.version = keys.choice("version", kVersions, o.version);
  o.trace_order = integer(keys, "trace_order", Range::between(2, 4), o.trace_order);
  o.particle_order = integer(keys, "particle_order", Range::between(2, 4), o.particle_order);
  o.particles_per_cell = integer(keys, "particles_per_cell", counts(), o.particles_per_cell);
  o.band = keys.number("band", Range::above(0), o.band);
  o.smallest_radius = keys.number("smallest_radius", Range::above(0), o.smallest_radius);
  o.largest_radius = keys.number("largest_radius", Range::above(0), o.largest_radius);
  o.escape = keys.number("escape", Range::at_least(0), o.escape);
  o.attraction_steps = integer(keys, "attraction_steps", counts(), o.attraction_steps);
  o.reinitialise_every = integer(keys, "reinitialise_every", counts(), o.reinitialise_every);
  o.reseed_every = integer(keys, "reseed_every", counts(), o.reseed_every);
  o.relaxation_steps =
      integer(keys, "relaxation_steps", Range::between(1, 1000), o.relaxation_steps);
  o.seed = static_cast<std::uint64_t>(keys.integer("seed", Range::at_least(0), 1));
}

void read(Keys& keys, ContouringOptions& o) {
  o.trace_order = integer(keys, "trace_order", Range::between(2, 4), o.trace_order);
  o.refinements = integer(keys, "refinements", Range::between(0, 100), o.refinements);
}

}  // namespace

const char* method_name(MethodKind kind) {
  for (const Named<MethodKind>& named : kKinds)
    if (named.value == kind) return named.name;
  return "";
}

MethodOptions read_method(Keys keys, const TrackerOptions& tracker) {
  MethodOptions method;
  method.kind = keys.choice("kind", kKinds, method.kind);
  const auto lattice_and_more = [&](auto& options) {
    read_lattice(keys, tracker, options);
    read(keys, options);
  };
  if (method.kind == MethodKind::level_set) lattice_and_more(method.level_set);
  if (method.kind == MethodKind::particle_level_set) lattice_and_more(method.particle_level_set);
  if (method.kind == MethodKind::semi_lagrangian_contouring) lattice_and_more(method.contouring);
  keys.done();
  return method;
}

}  // namespace suture::sims
