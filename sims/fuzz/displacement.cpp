// Values have the names that case files have for them, so the names may not change.
#include "sims/fuzz/displacement.h"

namespace suture::sims {

Operation displacement(const Perturbation& p) {
  Operation o{Operation::Kind::displace, {}};
  for (const auto& named : kPerturbNames)
    if (named.value == p.how) o.values["how"] = std::string(named.name);
  o.values["amount"] = p.amount;
  o.values["share"] = p.share;
  o.values["seed"] = static_cast<std::int64_t>(p.seed);
  return o;
}

Perturbation perturbation_of(const Operation& operation) {
  std::map<std::string, Keys::Entry> entries;
  for (const auto& [key, value] : operation.values) entries[key] = {value, "displace"};
  Keys keys(std::move(entries), "displace", "a displacement");
  Perturbation p;
  p.how = keys.choice("how", kPerturbNames, p.how);
  p.amount = keys.number("amount", Range::any(), p.amount);
  p.share = keys.number("share", Range::between(0, 1), p.share);
  p.seed = static_cast<std::uint64_t>(keys.integer("seed", Range::at_least(0), 0));
  keys.done();
  return p;
}

}  // namespace suture::sims
