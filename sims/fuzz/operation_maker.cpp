// Motions are drawn so that a step moves the surface by about a cell; some steps are far longer.
#include "sims/fuzz/operation_maker.h"

#include <cmath>

#include "sims/flows/motions.h"
#include "surgery/model/option_table.h"

namespace suture::sims {

namespace {

using Kind = Operation::Kind;

std::vector<double> list(const Point& p) { return {p[0], p[1], p[2]}; }

Point direction(Random& random) {
  return {random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(0.1, 1)};
}

class Maker {
 public:
  Maker(const OperationSizes& sizes, Random& random) : s_(sizes), random_(random) {}

  /// \param cells about how many cells the surface moves
  Operation advance(double cells) {
    const auto names = motion_names();
    Operation o{Kind::advance, {}};
    const std::string motion = names[random_.below(names.size())];
    auto& v = o.values;
    v["motion"] = motion;
    // At speeds of about one unit of length in a unit of time:
    double dt = cells * s_.cell / s_.unit * random_.uniform(0.3, 1.5);
    const double unit = s_.unit;
    if (motion == "rotation") {
      v["centre"] = list(s_.centre + unit * direction(random_));
      v["axis"] = list(direction(random_));
    } else if (motion == "enright") {
      v["variant"] = std::string(random_.below(2) == 0 ? "leveque" : "eltopo");
      v["period"] = random_.uniform(1, 4);
    } else if (motion == "curl_noise") {
      v["seed"] = static_cast<std::int64_t>(random_.below(1000000));
      v["waves"] = static_cast<std::int64_t>(1 + random_.below(6));
      v["wavelength"] = unit * random_.uniform(0.3, 3);
      v["speed"] = unit;
      v["period"] = random_.below(2) == 0 ? 0 : random_.uniform(0.5, 4);
      v["centre"] = list(s_.centre);
      v["radius"] = random_.below(2) == 0 ? 0 : 3 * unit;
    } else if (motion == "stretch") {
      v["centre"] = list(s_.centre);
      v["axis"] = list(direction(random_));
      v["rate"] = random_.uniform(-1, 1);
      v["width"] = random_.below(2) == 0 ? 0 : 0.5 * unit;
    } else if (motion == "fold") {
      v["centre"] = list(s_.centre);
      v["rate"] = random_.uniform(0, 1);
      v["amplitude"] = unit * random_.uniform(0, 1);
      v["wavelength"] = unit * random_.uniform(0.5, 3);
    } else if (motion == "normal_flow") {
      v["speed"] = unit * random_.uniform(-1, 1);
    } else if (motion == "mean_curvature") {
      v["rate"] = unit * unit * 0.1;
    } else if (motion == "bodies") {
      v["speed"] = unit;
      v["seed"] = static_cast<std::int64_t>(random_.below(1000000));
      v["relaxation"] = random_.uniform(0.01, 1);
    }
    v["dt"] = dt;
    return o;
  }

  Operation displace(double cells) {
    Spoiling s;
    s.how = kSpoilNames[random_.below(kSpoilNames.size())].value;
    s.amount = s.how == Spoil::scale ? 1 + cells * random_.uniform(-0.3, 0.3)
                                     : cells * random_.uniform(0, 0.6);
    s.share = random_.below(2) == 0 ? random_.uniform() : 1;
    if (s.how == Spoil::weld) s.share = 0.05 * cells;
    s.seed = random_.below(1ULL << 62);
    return displacement(s);
  }

  void motion(std::vector<Operation>& operations, double cells) {
    operations.push_back(random_.below(3) == 0 ? displace(cells) : advance(cells));
  }

 private:
  const OperationSizes& s_;
  Random& random_;
};

}  // namespace

std::vector<Operation> make_operations(Profile profile, const OperationSizes& sizes,
                                       Random& random) {
  Maker maker(sizes, random);
  std::vector<Operation> operations{{Kind::remodel, {}}};
  const bool fed_back = profile == Profile::fed_back;
  const std::uint64_t rounds = fed_back ? 8 + random.below(25) : 1 + random.below(5);
  const double cells = fed_back ? 0.5 : random.below(10) == 0 ? 20 : 1.5;
  for (std::uint64_t round = 0; round < rounds; ++round) {
    if (random.below(6) == 0) operations.push_back({Kind::improve, {}});
    maker.motion(operations, cells);
    if (random.below(6) == 0) operations.push_back({Kind::improve, {}});
    operations.push_back({Kind::remodel, {}});
  }
  operations.push_back({Kind::remodel, {}});  // what is settled stays
  return operations;
}

Operation displacement(const Spoiling& s) {
  Operation o{Kind::displace, {}};
  for (const auto& named : kSpoilNames)
    if (named.value == s.how) o.values["how"] = std::string(named.name);
  o.values["amount"] = s.amount;
  o.values["share"] = s.share;
  o.values["seed"] = static_cast<std::int64_t>(s.seed);
  return o;
}

Spoiling spoiling_of(const Operation& operation) {
  std::map<std::string, Keys::Entry> entries;
  for (const auto& [key, value] : operation.values) entries[key] = {value, "displace"};
  Keys keys(std::move(entries), "displace", "a displacement");
  Spoiling s;
  s.how = keys.choice("how", kSpoilNames, s.how);
  s.amount = keys.number("amount", Range::any(), s.amount);
  s.share = keys.number("share", Range::between(0, 1), s.share);
  s.seed = static_cast<std::uint64_t>(keys.integer("seed", Range::at_least(0), 0));
  keys.done();
  return s;
}

}  // namespace suture::sims
