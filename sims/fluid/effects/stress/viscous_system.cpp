// The equations of an implicit viscous step: masses, and stresses between faces.
#include "sims/fluid/effects/stress/viscous_system.h"

#include <algorithm>
#include <cmath>

#include "kernel/errors.h"

namespace suture::sims {
namespace {

/// Numbers the faces that are solved for, and makes terms of them.
class SystemBuilder {
 public:
  SystemBuilder(const MacVelocity& velocity, const StrainRate& rate, const StressStep& step)
      : velocity_(velocity), rate_(rate), step_(step) {
    system_.grid = rate.shared_grid();
  }

  ViscousSystem built(Unknowns unknowns) {
    number_faces(unknowns);
    rate_.for_each([&](const RateStencil& r, int component, Slot s) { add_term(r, component, s); });
    for (int a = 0; a < 3; ++a)
      if (held_[a] != 0) system_.wall_velocity[a] /= static_cast<double>(held_[a]);
    return std::move(system_);
  }

 private:
  double mass(int axis, Slot s) const {
    if (velocity_.known[axis][s] == 0) return 0;
    if (step_.projected != nullptr && !touches(*step_.projected, axis, s)) return 0;
    return rate_.fraction(axis, s);
  }
  void number_faces(Unknowns unknowns);
  ViscousSystem::Term term(const RateStencil& r) const;
  void add_term(const RateStencil& r, int component, Slot s);

  const MacVelocity& velocity_;
  const StrainRate& rate_;
  const StressStep& step_;
  ViscousSystem system_;
  std::array<std::vector<std::uint32_t>, 3> numbers_;
  std::array<std::size_t, 3> held_{};
};

void SystemBuilder::number_faces(Unknowns unknowns) {
  for (int a = 0; a < 3; ++a) numbers_[a].assign(rate_.grid().size(), kNone);
  rate_.for_each([&](const RateStencil& r, int, Slot) {
    for (int n = 0; n < r.faces; ++n)
      if (!rate_.held(r.axis[n], r.slot[n])) numbers_[r.axis[n]][r.slot[n]] = 0;
  });
  for (Slot s = 0; s < rate_.grid().size(); ++s)
    for (int a = 0; a < 3; ++a) {
      if (numbers_[a][s] == kNone) continue;
      const double own = mass(a, s);
      if (unknowns == Unknowns::massless && own > 0) {
        numbers_[a][s] = kNone;
        continue;
      }
      const double u = rate_.velocity_at(velocity_, a, s);
      if (!std::isfinite(u))
        throw InvalidInput("the velocity is not finite at a face across axis " + std::to_string(a) +
                           "; check what moved it in the step before");
      numbers_[a][s] = static_cast<std::uint32_t>(system_.faces.size());
      system_.faces.push_back({s, a});
      system_.before.push_back(u);
      system_.mass.push_back(own);
    }
}

ViscousSystem::Term SystemBuilder::term(const RateStencil& r) const {
  ViscousSystem::Term t;
  for (int n = 0; n < r.faces; ++n) {
    const auto way = static_cast<float>(r.coefficient[n]);
    t.unknown[n] = numbers_[r.axis[n]][r.slot[n]];
    if (t.unknown[n] == kNone) {
      t.constant += way * rate_.velocity_at(velocity_, r.axis[n], r.slot[n]);
      t.wall = true;
    } else {
      t.way[n] = way;
    }
  }
  return t;
}

void SystemBuilder::add_term(const RateStencil& r, int component, Slot s) {
  ViscousSystem::Term t = term(r);
  const double twice = component < 3 ? 1 : 2;  // a shear's stencil makes 2h·D
  t.stiffness = step_.stiffness * r.weight * 2 / twice;
  if (step_.factor != nullptr) t.stiffness *= step_.factor->part(component)[s];
  if (step_.offset != nullptr) t.constant += twice * step_.offset->part(component)[s];
  const bool free =
      std::any_of(t.unknown.begin(), t.unknown.end(), [](std::uint32_t u) { return u != kNone; });
  if (!free) return;
  system_.terms.push_back(t);
  for (int n = 0; n < r.faces; ++n) {
    if (t.unknown[n] != kNone) continue;
    system_.wall_velocity[r.axis[n]] += rate_.velocity_at(velocity_, r.axis[n], r.slot[n]);
    ++held_[r.axis[n]];
  }
}

std::size_t bytes(const std::vector<double>& x) { return x.capacity() * sizeof(double); }

}  // namespace

std::size_t ViscousSystem::memory() const {
  return faces.capacity() * sizeof(Face) + bytes(mass) + bytes(before) +
         terms.capacity() * sizeof(Term);
}

ViscousSystem viscous_system(const MacVelocity& velocity, const StrainRate& rate,
                             const StressStep& step, Unknowns unknowns) {
  return SystemBuilder(velocity, rate, step).built(unknowns);
}

}  // namespace suture::sims
