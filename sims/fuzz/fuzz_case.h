// A case: a surface, the tracker's options, and what is done with it. Self-contained.
#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "sims/support/keys.h"
#include "surgery/model/options.h"

namespace suture::sims {

/// One call of the tracker. `values` are its parameters by name, as a corpus file has them:
/// advance: motion, dt, that motion's own ones, and seed and speed for the motion `bodies`;
/// displace: see Spoiling; remodel and improve take none.
struct Operation {
  enum class Kind { advance, displace, remodel, improve };
  Kind kind = Kind::remodel;
  std::map<std::string, Value> values;

  bool operator==(const Operation&) const = default;
};

inline constexpr std::array<Named<Operation::Kind>, 4> kOperationNames = {
    {{"advance", Operation::Kind::advance},
     {"displace", Operation::Kind::displace},
     {"remodel", Operation::Kind::remodel},
     {"improve", Operation::Kind::improve}}};

struct FuzzCase {
  std::uint64_t seed = 0;
  std::string profile, generator;  ///< of the campaign that made it, and of its surface
  Triangles surface;
  TrackerOptions options;
  std::vector<Operation> operations;
};

}  // namespace suture::sims
