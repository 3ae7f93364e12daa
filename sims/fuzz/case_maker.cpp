// Surfaces are drawn about one unit across, with their operations; the whole case is then moved and
// scaled.
#include "sims/fuzz/case_maker.h"

#include <cmath>

#include "kernel/random.h"
#include "sims/fuzz/generators.h"
#include "sims/fuzz/operation_maker.h"
#include "sims/fuzz/perturbation.h"
#include "surgery/model/option_table.h"

namespace suture::sims {

namespace {

template <class T, std::size_t N>
T any_of(const std::array<Named<T>, N>& names, Random& random) {
  return names[random.below(N)].value;
}

QualityOptions any_quality(Random& random, double cell) {
  QualityOptions q;
  q.edge_length = random.below(2) == 0 ? 0 : cell * random.uniform(0.5, 2.5);
  q.keep_features = random.below(2) == 0;
  q.subdivision = any_of(kSubdivisionNames, random);
  if (random.below(3) == 0) {
    q.chord_error = cell * random.uniform(0.001, 0.2);
    q.finest = random.uniform(0.2, 1);
  }
  q.passes = static_cast<int>(1 + random.below(3));
  if (random.below(4) == 0) {
    q.longest = random.uniform(1.2, 2);
    q.shortest = random.uniform(0.1, 0.6);
    q.smallest_angle = random.uniform(0, 30);
    q.largest_angle = random.uniform(110, 179);
    q.volume_bound = random.uniform(0, 0.2);
    q.turn_bound = random.uniform(10, 90);
    q.feature_angle = random.uniform(10, 90);
  }
  return q;
}

TrackerOptions any_options(Random& random, double cell) {
  TrackerOptions o;
  o.cell_size = cell;
  if (random.below(4) == 0) o.origin = Point::Constant(random.uniform(0, cell));
  if (random.below(3) == 0) o.events = any_of(kEventsNames, random);
  if (random.below(4) == 0) o.cell_test = CellTest::plain;
  if (random.below(2) == 0) o.depth = static_cast<int>(random.below(3));
  o.collapse = any_of(kCollapseNames, random);
  o.placement = any_of(kPlacementNames, random);
  if (random.below(8) == 0) o.straighten_turn = random.uniform(0, 180);
  o.quality = any_quality(random, cell);
  return o;
}

Spoiling any_spoiling(Random& random) {
  Spoiling s;
  s.how = any_of(kSpoilNames, random);
  s.amount = s.how == Spoil::scale ? random.uniform(0.5, 1.5) : random.uniform(0, 1);
  s.share = random.below(2) == 0 ? 1 : random.uniform();
  s.seed = random.next();
  return s;
}

/// By a power of two nothing changes but the exponents; far away features vanish into rounding.
void take_elsewhere(FuzzCase& c, Random& random, OperationSizes& sizes) {
  const std::uint64_t how = random.below(6);
  if (how <= 1) {
    const int most = how == 0 ? 16 : 180;
    const double factor = std::ldexp(1.0, static_cast<int>(random.below(2 * most + 1)) - most);
    for (Point& p : c.surface.positions) p *= factor;
    c.options.cell_size *= factor;
    c.options.origin *= factor;
    c.options.quality.edge_length *= factor;
    c.options.quality.chord_error *= factor;
    sizes.unit = factor;
  } else if (how == 2) {
    const double away = std::ldexp(1.0, static_cast<int>(random.below(36)));
    const Point by(away, -away * random.uniform(), away / 3);
    for (Point& p : c.surface.positions) p += by;
    if (random.below(2) == 0) c.options.origin += by;
    sizes.centre += by;
  }
}

Profile decided(Profile profile, Random& random) {
  constexpr Profile kAll[] = {Profile::random, Profile::hostile, Profile::hostile,
                              Profile::fed_back};
  const Profile any = kAll[random.below(4)];
  return profile == Profile::all ? any : profile;
}

}  // namespace

FuzzCase make_case(std::uint64_t seed, const CaseOptions& options) {
  Random random(seed);
  FuzzCase c;
  c.seed = seed;
  const Profile profile = decided(options.profile, random);
  for (const auto& named : kProfileNames)
    if (named.value == profile) c.profile = named.name;
  const auto names = generator_names();
  c.generator = names[random.below(names.size())];
  const bool large = random.below(64) == 0;
  double cell = std::ldexp(1.0, -static_cast<int>(1 + random.below(large ? 4 : 2)));
  if (random.below(3) == 0) cell *= random.uniform(0.8, 1.6);
  c.options = any_options(random, cell);
  c.options.arithmetic = options.arithmetic;
  if (options.collapse) c.options.collapse = *options.collapse;
  if (options.jitter) c.options.jitter = *options.jitter;
  c.surface = generate(c.generator, {random, cell, large});
  OperationSizes sizes{1, Point::Zero(), cell};
  if (profile != Profile::random)
    for (std::uint64_t n = random.below(3); n > 0; --n)
      spoil(c.surface.positions, any_spoiling(random), cell, c.options.origin);
  if (profile == Profile::hostile) take_elsewhere(c, random, sizes);
  sizes.cell = c.options.cell_size;
  c.operations = make_operations(profile, sizes, random);
  return c;
}

}  // namespace suture::sims
