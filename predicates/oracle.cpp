// Each arithmetic has its oracle.
#include "predicates/oracle.h"

#include "kernel/errors.h"

namespace suture {

std::unique_ptr<Oracle> make_oracle(Arithmetic arithmetic) {
  switch (arithmetic) {
    case Arithmetic::rounded:
      return make_rounded_oracle();
    case Arithmetic::filtered:
      return make_filtered_oracle();
    case Arithmetic::rational:
      return make_rational_oracle();
  }
  throw InvalidInput("there is no such arithmetic");
}

}  // namespace suture
