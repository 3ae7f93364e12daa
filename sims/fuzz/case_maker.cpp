// A surface is drawn about one unit across. A hostile case is then moved or scaled as a whole.
#include "sims/fuzz/case_maker.h"

#include <cmath>

#include "sims/flows/motions.h"
#include "sims/fuzz/named_options.h"
#include "sims/fuzz/operation_maker.h"
#include "sims/fuzz/perturbation.h"

namespace suture::sims {

namespace {

/// The profile asked for, or one by the seed; half of the cases are hostile.
Profile decided(Profile profile, const Draws& draws) {
  if (profile != Profile::all) return profile;
  const std::string name = draws.choice("profile", {"random", "hostile", "hostile", "fed_back"});
  for (const auto& named : kProfileNames)
    if (name == named.name) profile = named.value;
  return profile;
}

const Generator& any_generator(const std::vector<Generator>& known, const Draws& draws) {
  std::vector<std::string> names;
  for (const Generator& generator : known) names.push_back(generator.name);
  return generator_named(draws.choice("generator", names), known);
}

Perturbation any_perturbation(const Draws& d) {
  Perturbation p;
  p.how = d.choice("how", kPerturbNames);
  p.amount = p.how == Perturb::scale ? d.uniform("factor", 0.5, 1.5) : d.uniform("amount", 0, 1);
  p.share = d.once_in("all", 2) ? 1 : d.uniform("share", 0, 1);
  p.seed = d.of("seed").next();
  return p;
}

void scale_by_power(int exponent, FuzzCase& c, OperationSizes& sizes) {
  sizes.unit = std::ldexp(1.0, exponent);
  for (Point& p : c.surface.positions) p *= sizes.unit;
  scale_lengths(c.options, exponent);
}

/// The case is scaled or moved, or stays. A power of two changes nothing but the exponents; far
/// from the origin small features vanish into rounding.
void take_elsewhere(FuzzCase& c, const Draws& d, OperationSizes& sizes) {
  const std::string how =
      d.choice("elsewhere", {"scaled", "scaled far", "moved", "here", "here", "here"});
  if (how == "scaled") scale_by_power(d.whole("exponent", -16, 16), c, sizes);
  if (how == "scaled far") scale_by_power(d.whole("far exponent", -180, 180), c, sizes);
  if (how == "moved") {
    const double away = std::ldexp(1.0, d.whole("exponent of the way", 0, 35));
    const Point by(away, -away * d.uniform("sideways", 0, 1), away / 3);
    for (Point& p : c.surface.positions) p += by;
    if (d.once_in("lattice too", 2)) c.options.origin += by;
    sizes.centre += by;
  }
}

std::string name_of(Profile profile) {
  for (const auto& named : kProfileNames)
    if (named.value == profile) return named.name;
  return {};
}

}  // namespace

const CaseParts& case_parts() {
  static const CaseParts parts{generators(), motion_names(), option_draws()};
  return parts;
}

FuzzCase make_case(std::uint64_t seed, const CaseOptions& options, const CaseParts& parts) {
  const Draws draws(seed);
  const Profile profile = decided(options.profile, draws);
  const Generator& generator = any_generator(parts.generators, draws);
  const CaseSize size = draws.once_in("large", 64) ? CaseSize::large : CaseSize::usual;
  FuzzCase c{seed, name_of(profile), generator.name, {}, {}, {}};
  c.options = draw_options(draws.in("options"), parts.options, size);
  c.options.arithmetic = options.arithmetic;
  if (options.collapse) c.options.collapse = *options.collapse;
  if (options.jitter) c.options.jitter = *options.jitter;
  const double cell = c.options.cell_size;
  c.surface = generator.make({draws.in("surface").in(generator.name), cell, size});
  OperationSizes sizes{1, Point::Zero(), cell};
  if (profile != Profile::random)
    for (int n = 0, count = draws.whole("perturbations", 0, 2); n < count; ++n)
      perturb(c.surface.positions,
              any_perturbation(draws.in("perturbation", static_cast<std::uint64_t>(n))),
              {cell, c.options.origin});
  if (profile == Profile::hostile) take_elsewhere(c, draws.in("elsewhere"), sizes);
  sizes.cell = c.options.cell_size;
  c.operations = make_operations(profile, sizes, {draws.in("operations"), parts.motions});
  return c;
}

}  // namespace suture::sims
