// Which oracle an arithmetic means.
#include "predicates/oracle.h"

namespace suture {

std::unique_ptr<Oracle> make_oracle(Arithmetic arithmetic) {
  return arithmetic == Arithmetic::rational ? make_rational_oracle() : make_filtered_oracle();
}

}  // namespace suture
