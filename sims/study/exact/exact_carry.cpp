// Points carried through a scene's motions with an error that nothing measured here can see.
#include <boost/numeric/odeint/integrate/integrate_adaptive.hpp>
#include <boost/numeric/odeint/stepper/controlled_runge_kutta.hpp>
#include <boost/numeric/odeint/stepper/generation.hpp>
#include <boost/numeric/odeint/stepper/runge_kutta_fehlberg78.hpp>

#include <algorithm>

#include "kernel/errors.h"
#include "sims/study/exact/exact_flow.h"

namespace suture::sims {
namespace {

namespace odeint = boost::numeric::odeint;
using State = std::array<double, 3>;

constexpr double kFirstStep = 0.02;  // of the whole time; the integrator finds its own at once

/// A field and the times between which it moves things.
struct Stretch {
  VelocityField field;
  double from, to;
};

// Boost's steppers copy their working memory before anything is in it, which g++ 12 notices.
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wuninitialized"
void carry_through(State& x, const Stretch& part, double error) {
  const auto system = [&part](const State& at, State& rate, double t) {
    const Point u = part.field(Point(at[0], at[1], at[2]), t);
    rate = {u[0], u[1], u[2]};
  };
  using Method = odeint::runge_kutta_fehlberg78<State>;
  odeint::integrate_adaptive(odeint::make_controlled<Method>(error, 0.0), system, x, part.from,
                             part.to, kFirstStep * (part.to - part.from));
}
#pragma GCC diagnostic pop

}  // namespace

Carry exact_carry(const Scene& scene, double time, double error) {
  std::vector<Stretch> parts;
  double from = 0;
  for (const Phase& phase : scene.phases) {
    if (from >= time) break;
    const VelocityField* field = phase.motion->field();
    if (field == nullptr)
      throw InvalidInput(scene.file.string() + ": the motion " + phase.kind +
                         " depends on the surface, so nothing exact is known of it; give "
                         "reference = \"none\" in [measure], or a mesh file");
    const double to = std::min(time, phase.until);
    parts.push_back({*field, from, to});
    from = to;
  }
  return [parts = std::move(parts), error](const Point& p) -> Point {
    State x{p[0], p[1], p[2]};
    for (const Stretch& part : parts) carry_through(x, part, error);
    return {x[0], x[1], x[2]};
  };
}

}  // namespace suture::sims
