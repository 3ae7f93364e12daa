// The motions by name, with their parameters and the ranges these may have.
#include "sims/flows/motions.h"

#include <array>

#include "kernel/errors.h"
#include "sims/flows/bodies.h"
#include "sims/flows/fields.h"
#include "sims/flows/mean_curvature.h"
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

/// A field as a motion; with the key `reversal` all is back in place at that time.
MotionPtr make_field(Keys& keys, VelocityField field) {
  const double time = keys.number("reversal", Range::at_least(0), 0);
  return std::make_unique<FieldMotion>(time > 0 ? reversed(std::move(field), time)
                                                : std::move(field));
}

MotionPtr make_translation(Keys& keys, const Velocities&) {
  return make_field(keys, translation(keys.vector("velocity", Point::UnitX())));
}

MotionPtr make_vortex(Keys& keys, const Velocities&) { return make_field(keys, vortex()); }

MotionPtr make_rotation(Keys& keys, const Velocities&) {
  RotationParameters p;
  p.centre = keys.vector("centre", p.centre);
  p.axis = keys.vector("axis", p.axis);
  p.rate = keys.number("rate", Range::any(), p.rate);
  return make_field(keys, rotation(p));
}

MotionPtr make_enright(Keys& keys, const Velocities&) {
  constexpr std::array<Named<EnrightVariant>, 2> variants = {
      {{"leveque", EnrightVariant::leveque}, {"eltopo", EnrightVariant::eltopo}}};
  EnrightParameters p;
  p.variant = keys.choice("variant", variants, p.variant);
  p.period = keys.number("period", Range::above(0), p.period);
  return std::make_unique<FieldMotion>(enright(p));
}

MotionPtr make_curl_noise(Keys& keys, const Velocities&) {
  CurlNoiseParameters p;
  p.seed = static_cast<std::uint64_t>(keys.integer("seed", Range::at_least(0), 1));
  p.waves = static_cast<int>(keys.integer("waves", Range::between(1, 10000), p.waves));
  p.wavelength = keys.number("wavelength", Range::above(0), p.wavelength);
  p.speed = keys.number("speed", Range::any(), p.speed);
  p.period = keys.number("period", Range::at_least(0), p.period);
  p.centre = keys.vector("centre", p.centre);
  p.radius = keys.number("radius", Range::at_least(0), p.radius);
  return make_field(keys, curl_noise(p));
}

MotionPtr make_stretch(Keys& keys, const Velocities&) {
  StretchParameters p;
  p.centre = keys.vector("centre", p.centre);
  p.axis = keys.vector("axis", p.axis);
  p.rate = keys.number("rate", Range::any(), p.rate);
  p.width = keys.number("width", Range::at_least(0), p.width);
  return make_field(keys, stretch(p));
}

MotionPtr make_fold(Keys& keys, const Velocities&) {
  FoldParameters p;
  p.centre = keys.vector("centre", p.centre);
  p.axis = keys.vector("axis", p.axis);
  p.up = keys.vector("up", p.up);
  p.rate = keys.number("rate", Range::any(), p.rate);
  p.amplitude = keys.number("amplitude", Range::any(), p.amplitude);
  p.wavelength = keys.number("wavelength", Range::above(0), p.wavelength);
  return make_field(keys, fold(p));
}

MotionPtr make_normal_flow(Keys& keys, const Velocities&) {
  const double speed = keys.number("speed", Range::any(), 1);
  return std::make_unique<SurfaceMotion>(
      [speed](const Triangles& surface, double dt) { return normal_flow(surface, speed * dt); });
}

MotionPtr make_mean_curvature(Keys& keys, const Velocities&) {
  const double rate = keys.number("rate", Range::above(0), 1);
  return std::make_unique<SurfaceMotion>([rate](const Triangles& surface, double dt) {
    return mean_curvature_flow(surface, rate * dt);
  });
}

MotionPtr make_bodies(Keys& keys, const Velocities& velocities) {
  return make_bodies_motion(velocities, keys.number("relaxation", Range::above(0), 1));
}

struct Maker {
  const char* name;
  MotionPtr (*make)(Keys&, const Velocities&);
};
constexpr std::array<Maker, 11> kMakers = {{{"bodies", make_bodies},
                                            {"curl_noise", make_curl_noise},
                                            {"enright", make_enright},
                                            {"fold", make_fold},
                                            {"mean_curvature", make_mean_curvature},
                                            {"normal_flow", make_normal_flow},
                                            {"rest", make_rest},
                                            {"rotation", make_rotation},
                                            {"stretch", make_stretch},
                                            {"translation", make_translation},
                                            {"vortex", make_vortex}}};

}  // namespace

std::vector<std::string> motion_names() {
  std::vector<std::string> names;
  for (const Maker& maker : kMakers) names.emplace_back(maker.name);
  return names;
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
