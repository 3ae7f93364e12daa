#include <catch2/catch.hpp>

#include "kernel/errors.h"
#include "sims/fuzz/displacement.h"

using namespace suture;
using namespace suture::sims;

TEST_CASE("a displacement survives its way through an operation") {
  const Perturbation s{Perturb::weld, 0.25, 0.5, 77};
  const Perturbation again = perturbation_of(displacement(s));
  CHECK(again.how == s.how);
  CHECK(again.amount == s.amount);
  CHECK(again.share == s.share);
  CHECK(again.seed == s.seed);
}

TEST_CASE("a displacement with a value that is none of its own is refused") {
  Operation operation = displacement({});
  operation.values["amounts"] = 0.5;
  CHECK_THROWS_AS(perturbation_of(operation), InvalidInput);
  operation = displacement({});
  operation.values["how"] = std::string("shake");
  CHECK_THROWS_AS(perturbation_of(operation), InvalidInput);
}
