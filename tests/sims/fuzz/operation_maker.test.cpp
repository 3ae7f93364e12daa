#include <catch2/catch.hpp>
#include <set>

#include "sims/flows/motions.h"
#include "sims/fuzz/displacement.h"
#include "sims/fuzz/operation_maker.h"

using namespace suture;
using namespace suture::sims;

namespace {

const OperationSizes kSizes{2, Point(1, 0, 0), 0.25};

std::vector<Operation> made(Profile profile, std::uint64_t seed,
                            const std::vector<std::string>& motions = motion_names()) {
  return make_operations(profile, kSizes, {Draws(seed), motions});
}

}  // namespace

TEST_CASE("a case begins with a remodel, ends with two, and remodels after each motion") {
  for (const Profile profile : {Profile::random, Profile::hostile, Profile::fed_back})
    for (std::uint64_t seed = 1; seed <= 50; ++seed) {
      const auto operations = made(profile, seed);
      std::size_t remodels = 0;
      for (const Operation& o : operations) remodels += o.kind == Operation::Kind::remodel ? 1 : 0;
      CHECK(operations.front().kind == Operation::Kind::remodel);
      CHECK(operations[operations.size() - 2].kind == Operation::Kind::remodel);
      CHECK(operations.back().kind == Operation::Kind::remodel);
      CHECK(remodels >= (profile == Profile::fed_back ? 10U : 3U));
      CHECK(remodels <= (profile == Profile::fed_back ? 34U : 7U));
    }
}

TEST_CASE("all motions occur, and the parameters that are drawn for them are theirs") {
  std::set<std::string> motions, perturbations;
  for (std::uint64_t seed = 1; seed <= 400; ++seed)
    for (const Operation& o : made(Profile::random, seed)) {
      if (o.kind == Operation::Kind::displace) {
        CHECK_NOTHROW(perturbation_of(o));
        perturbations.insert(std::get<std::string>(o.values.at("how")));
      }
      if (o.kind != Operation::Kind::advance) continue;
      const std::string motion = std::get<std::string>(o.values.at("motion"));
      motions.insert(motion);
      std::map<std::string, Keys::Entry> entries;
      for (const auto& [key, value] : o.values)
        if (key != "motion" && key != "dt" &&
            !(motion == "bodies" && (key == "seed" || key == "speed")))
          entries[key] = {value, "here"};
      Keys keys(std::move(entries), "motion", "here");
      CHECK_NOTHROW(make_motion(motion, keys, {}));
    }
  CHECK(motions.size() == motion_names().size());
  CHECK(perturbations.size() == kPerturbNames.size());
}

TEST_CASE("a motion more changes no operation but those that it takes over") {
  std::vector<std::string> more = motion_names();
  more.insert(more.begin(), "a new one");
  int advances = 0, taken = 0;
  for (std::uint64_t seed = 1; seed <= 400; ++seed) {
    const auto before = made(Profile::hostile, seed), after = made(Profile::hostile, seed, more);
    REQUIRE(before.size() == after.size());
    for (std::size_t i = 0; i < before.size(); ++i) {
      const bool advance = after[i].kind == Operation::Kind::advance;
      advances += advance ? 1 : 0;
      if (!advance || after[i].values.at("motion") != Value("a new one")) {
        CHECK(before[i] == after[i]);
        continue;
      }
      ++taken;
      CHECK(before[i].kind == after[i].kind);
      CHECK(before[i].values.at("dt") == after[i].values.at("dt"));
    }
  }
  CHECK(taken / static_cast<double>(advances) ==
        Approx(1 / static_cast<double>(more.size())).margin(0.03));
}
