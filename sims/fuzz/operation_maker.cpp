// Motions are drawn so that a step moves the surface by about a cell; some steps are far longer.
#include "sims/fuzz/operation_maker.h"

#include "sims/fuzz/displacement.h"

namespace suture::sims {

namespace {

using Kind = Operation::Kind;
using Values = std::map<std::string, Value>;
using Sizes = OperationSizes;

std::vector<double> list(const Point& p) { return {p[0], p[1], p[2]}; }

Point direction(const Draws& d, const char* name) {
  Random random = d.of(name);
  return {random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(0.1, 1)};
}

std::int64_t below(const Draws& d, const char* name, std::uint64_t count) {
  return static_cast<std::int64_t>(d.of(name).below(count));
}

Values rotation(const Draws& d, const Sizes& s) {
  return {{"centre", list(s.centre + s.unit * direction(d, "centre"))},
          {"axis", list(direction(d, "axis"))}};
}

Values enright(const Draws& d, const Sizes&) {
  return {{"variant", d.choice("variant", {"leveque", "eltopo"})},
          {"period", d.uniform("period", 1, 4)}};
}

Values curl_noise(const Draws& d, const Sizes& s) {
  return {{"seed", below(d, "seed", 1000000)},
          {"waves", 1 + below(d, "waves", 6)},
          {"wavelength", s.unit * d.uniform("wavelength", 0.3, 3)},
          {"speed", s.unit},
          {"period", d.once_in("steady", 2) ? 0.0 : d.uniform("period", 0.5, 4)},
          {"centre", list(s.centre)},
          {"radius", d.once_in("everywhere", 2) ? 0.0 : 3 * s.unit}};
}

Values stretch(const Draws& d, const Sizes& s) {
  return {{"centre", list(s.centre)},
          {"axis", list(direction(d, "axis"))},
          {"rate", d.uniform("rate", -1, 1)},
          {"width", d.once_in("everywhere", 2) ? 0.0 : 0.5 * s.unit}};
}

Values fold(const Draws& d, const Sizes& s) {
  return {{"centre", list(s.centre)},
          {"rate", d.uniform("rate", 0, 1)},
          {"amplitude", s.unit * d.uniform("amplitude", 0, 1)},
          {"wavelength", s.unit * d.uniform("wavelength", 0.5, 3)}};
}

Values normal_flow(const Draws& d, const Sizes& s) {
  return {{"speed", s.unit * d.uniform("speed", -1, 1)}};
}

Values mean_curvature(const Draws&, const Sizes& s) { return {{"rate", s.unit * s.unit * 0.1}}; }

Values bodies(const Draws& d, const Sizes& s) {
  return {{"speed", s.unit},
          {"seed", below(d, "seed", 1000000)},
          {"relaxation", d.uniform("relaxation", 0.01, 1)}};
}

/// How a motion's parameters are drawn, at speeds of about one unit in a unit of time.
struct MotionDraw {
  const char* motion;
  Values (*parameters)(const Draws&, const Sizes&);
};
constexpr std::array<MotionDraw, 8> kMotionDraws = {{{"bodies", bodies},
                                                     {"curl_noise", curl_noise},
                                                     {"enright", enright},
                                                     {"fold", fold},
                                                     {"mean_curvature", mean_curvature},
                                                     {"normal_flow", normal_flow},
                                                     {"rotation", rotation},
                                                     {"stretch", stretch}}};

/// One round of a case.
struct Round {
  Draws draws;
  double cells;  ///< about how many cells the surface moves
};

Operation advance(const Round& round, const Sizes& s, const std::vector<std::string>& motions) {
  Operation o{Kind::advance, {}};
  const std::string motion = round.draws.choice("motion", motions);
  for (const MotionDraw& draw : kMotionDraws)
    if (motion == draw.motion) o.values = draw.parameters(round.draws.in(motion), s);
  o.values["motion"] = motion;
  o.values["dt"] = round.cells * s.cell / s.unit * round.draws.uniform("dt", 0.3, 1.5);
  return o;
}

Operation displace(const Round& round) {
  const Draws d = round.draws.in("displacement");
  Perturbation p;
  p.how = d.choice("how", kPerturbNames);
  p.amount = p.how == Perturb::scale ? 1 + round.cells * d.uniform("factor", -0.3, 0.3)
                                     : round.cells * d.uniform("amount", 0, 0.6);
  p.share = d.once_in("a share", 2) ? d.uniform("share", 0, 1) : 1;
  if (p.how == Perturb::weld) p.share = 0.05 * round.cells;
  p.seed = d.of("seed").below(1ULL << 62);
  return displacement(p);
}

}  // namespace

std::vector<Operation> make_operations(Profile profile, const OperationSizes& sizes,
                                       const OperationDraws& from) {
  const Draws& d = from.draws;
  const bool fed_back = profile == Profile::fed_back;
  const int rounds = fed_back ? d.whole("rounds fed back", 8, 32) : d.whole("rounds", 1, 5);
  const double cells = fed_back ? 0.5 : d.once_in("far", 10) ? 20 : 1.5;
  std::vector<Operation> operations{{Kind::remodel, {}}};
  for (int r = 0; r < rounds; ++r) {
    const Round round{d.in("round", static_cast<std::uint64_t>(r)), cells};
    if (round.draws.once_in("improve first", 6)) operations.push_back({Kind::improve, {}});
    operations.push_back(round.draws.once_in("displace", 3) ? displace(round)
                                                            : advance(round, sizes, from.motions));
    if (round.draws.once_in("improve", 6)) operations.push_back({Kind::improve, {}});
    operations.push_back({Kind::remodel, {}});
  }
  operations.push_back({Kind::remodel, {}});  // what is settled stays
  return operations;
}

}  // namespace suture::sims
