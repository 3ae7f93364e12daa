// The ways to track a surface that a scene can name, with their options.
#pragma once

#include "sims/baselines/contouring/contouring_options.h"
#include "sims/baselines/level_set/level_set_options.h"
#include "sims/baselines/particle_level_set/particle_level_set_options.h"
#include "sims/support/keys.h"
#include "surgery/model/options.h"

namespace suture::sims {

enum class MethodKind {
  mesh,                   ///< the tracker, with all that the scene says of it
  mesh_without_topology,  ///< improved as the scene says, never remodelled [§9]
  markers,                ///< neither: vertices carried by RK4
  level_set,
  particle_level_set,
  semi_lagrangian_contouring
};

/// The table [method] of a scene. Only the options of its kind mean anything.
struct MethodOptions {
  MethodKind kind = MethodKind::mesh;
  LevelSetOptions level_set;
  ParticleLevelSetOptions particle_level_set;
  ContouringOptions contouring;

  /// Whether it is the tracker's mesh, looked after or not.
  bool is_mesh() const {
    return kind == MethodKind::mesh || kind == MethodKind::mesh_without_topology ||
           kind == MethodKind::markers;
  }
};

/// The word by which scenes name it.
const char* method_name(MethodKind kind);

/// Reads [method], which may hold the keys of its kind and nothing else; cells and origin are the
/// tracker's where it does not say. \throw InvalidInput with the key and what is allowed
MethodOptions read_method(Keys keys, const TrackerOptions& tracker);

/// The table of the kind; each baseline has one of its own.
const OptionTable<MethodOptions>& method_options();

}  // namespace suture::sims
