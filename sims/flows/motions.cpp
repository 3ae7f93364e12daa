// The motions by name, with their parameters and the ranges these may have.
#include "sims/flows/motions.h"

#include <array>

#include "kernel/errors.h"
#include "sims/flows/bodies.h"
#include "sims/flows/fields.h"
#include "sims/flows/mean_curvature.h"
#include "sims/flows/motion_options.h"
#include "sims/flows/normal_flow.h"

namespace suture::sims {
namespace {

class FieldMotion : public Motion {
 public:
  explicit FieldMotion(VelocityField field) : field_(std::move(field)) {}
  const VelocityField* field() const override { return &field_; }
  std::vector<Point> positions(const Triangles&, double) override {
    throw InternalFailure("motion", "a velocity field was asked for positions");
  }

 private:
  VelocityField field_;
};

/// A motion whose new positions follow from the surface and the time step alone.
class SurfaceMotion : public Motion {
 public:
  using Step = std::function<std::vector<Point>(const Triangles&, double dt)>;
  explicit SurfaceMotion(Step step) : step_(std::move(step)) {}
  std::vector<Point> positions(const Triangles& surface, double dt) override {
    return step_(surface, dt);
  }

 private:
  Step step_;
};

using Velocities = std::vector<Point>;
using MotionPtr = std::unique_ptr<Motion>;

MotionPtr make_rest(Keys&, const Velocities&) {
  return std::make_unique<SurfaceMotion>(
      [](const Triangles& surface, double) { return surface.positions; });
}

/// The parameters of a table as the keys have them.
template <class Parameters>
Parameters given(Keys& keys, const OptionTable<Parameters>& table) {
  Parameters parameters;
  read(keys, table, parameters);
  return parameters;
}

/// A field as a motion, reversed where the keys say so.
MotionPtr make_field(Keys& keys, VelocityField field) {
  const double time = given(keys, reversal_parameters()).reversal;
  return std::make_unique<FieldMotion>(time > 0 ? reversed(std::move(field), time)
                                                : std::move(field));
}

MotionPtr make_translation(Keys& keys, const Velocities&) {
  return make_field(keys, translation(given(keys, translation_parameters()).velocity));
}

MotionPtr make_vortex(Keys& keys, const Velocities&) { return make_field(keys, vortex()); }

MotionPtr make_rotation(Keys& keys, const Velocities&) {
  return make_field(keys, rotation(given(keys, rotation_parameters())));
}

MotionPtr make_enright(Keys& keys, const Velocities&) {
  return std::make_unique<FieldMotion>(enright(given(keys, enright_parameters())));
}

MotionPtr make_curl_noise(Keys& keys, const Velocities&) {
  return make_field(keys, curl_noise(given(keys, curl_noise_parameters())));
}

MotionPtr make_stretch(Keys& keys, const Velocities&) {
  return make_field(keys, stretch(given(keys, stretch_parameters())));
}

MotionPtr make_fold(Keys& keys, const Velocities&) {
  return make_field(keys, fold(given(keys, fold_parameters())));
}

MotionPtr make_normal_flow(Keys& keys, const Velocities&) {
  const double speed = given(keys, normal_flow_parameters()).speed;
  return std::make_unique<SurfaceMotion>(
      [speed](const Triangles& surface, double dt) { return normal_flow(surface, speed * dt); });
}

MotionPtr make_mean_curvature(Keys& keys, const Velocities&) {
  const double rate = given(keys, mean_curvature_parameters()).rate;
  return std::make_unique<SurfaceMotion>([rate](const Triangles& surface, double dt) {
    return mean_curvature_flow(surface, rate * dt);
  });
}

MotionPtr make_bodies(Keys& keys, const Velocities& velocities) {
  return make_bodies_motion(velocities, given(keys, bodies_parameters()).relaxation);
}

using Infos = std::vector<OptionInfo>;

/// The parameters of a field, and those of its reversal.
Infos of_field(Infos parameters = {}) {
  for (const OptionInfo& more : infos(reversal_parameters())) parameters.push_back(more);
  return parameters;
}

struct Maker {
  const char* name;
  MotionPtr (*make)(Keys&, const Velocities&);
  Infos (*parameters)();
};
constexpr std::array<Maker, 11> kMakers = {
    {{"bodies", make_bodies, [] { return infos(bodies_parameters()); }},
     {"curl_noise", make_curl_noise, [] { return of_field(infos(curl_noise_parameters())); }},
     {"enright", make_enright, [] { return infos(enright_parameters()); }},
     {"fold", make_fold, [] { return of_field(infos(fold_parameters())); }},
     {"mean_curvature", make_mean_curvature, [] { return infos(mean_curvature_parameters()); }},
     {"normal_flow", make_normal_flow, [] { return infos(normal_flow_parameters()); }},
     {"rest", make_rest, [] { return Infos(); }},
     {"rotation", make_rotation, [] { return of_field(infos(rotation_parameters())); }},
     {"stretch", make_stretch, [] { return of_field(infos(stretch_parameters())); }},
     {"translation", make_translation, [] { return of_field(infos(translation_parameters())); }},
     {"vortex", make_vortex, [] { return of_field(); }}}};

}  // namespace

std::vector<std::string> motion_names() {
  std::vector<std::string> names;
  for (const Maker& maker : kMakers) names.emplace_back(maker.name);
  return names;
}

std::vector<OptionInfo> motion_parameters(const std::string& kind) {
  for (const Maker& maker : kMakers)
    if (kind == maker.name) return maker.parameters();
  return {};
}

std::unique_ptr<Motion> make_motion(const std::string& kind, Keys& keys,
                                    const std::vector<Point>& velocities) {
  for (const Maker& maker : kMakers) {
    if (kind != maker.name) continue;
    MotionPtr motion = maker.make(keys, velocities);
    keys.done();
    return motion;
  }
  const std::string near = nearest_name(kind, motion_names());
  throw InvalidInput("there is no motion \"" + kind + "\"" +
                     (near.empty() ? "" : "; did you mean \"" + near + "\"?") + "; there are " +
                     joined(motion_names()));
}

}  // namespace suture::sims
