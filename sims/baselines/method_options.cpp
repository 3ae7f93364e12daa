// The table [method] of a scene: the kind, and the options that this kind has.
#include "sims/baselines/method_options.h"

namespace suture::sims {
namespace {

constexpr std::array<Named<MethodKind>, 6> kKinds = {
    {{"mesh", MethodKind::mesh},
     {"mesh_without_topology", MethodKind::mesh_without_topology},
     {"markers", MethodKind::markers},
     {"level_set", MethodKind::level_set},
     {"particle_level_set", MethodKind::particle_level_set},
     {"semi_lagrangian_contouring", MethodKind::semi_lagrangian_contouring}}};

const OptionTable<MethodOptions> kMethod(
    "method", {{"kind",
                {&MethodOptions::kind, kKinds},
                {.meaning = "what tracks the surface: the mesh as the scene says; the mesh "
                            "improved but never remodelled; its vertices alone; or a baseline",
                 .source = "§9"}}});

/// Reads options whose lattice is the tracker's where the keys do not say.
template <class Options>
void read_baseline(Keys& keys, const TrackerOptions& tracker, const OptionTable<Options>& table,
                   Options& options) {
  options.cell_size = tracker.cell_size;
  options.origin = tracker.origin;
  read(keys, table, options);
}

}  // namespace

const char* method_name(MethodKind kind) {
  for (const Named<MethodKind>& named : kKinds)
    if (named.value == kind) return named.name;
  return "";
}

const OptionTable<MethodOptions>& method_options() { return kMethod; }

MethodOptions read_method(Keys keys, const TrackerOptions& tracker) {
  MethodOptions method;
  read(keys, method_options(), method);
  if (method.kind == MethodKind::level_set)
    read_baseline(keys, tracker, level_set_options(), method.level_set);
  if (method.kind == MethodKind::particle_level_set)
    read_baseline(keys, tracker, particle_level_set_options(), method.particle_level_set);
  if (method.kind == MethodKind::semi_lagrangian_contouring)
    read_baseline(keys, tracker, contouring_options(), method.contouring);
  keys.done();
  return method;
}

}  // namespace suture::sims
