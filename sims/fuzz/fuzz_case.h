// A case: a surface, the tracker's options, and what is done with it. It refers to nothing outside.
#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "sims/support/keys.h"
#include "surgery/model/options.h"

namespace suture::sims {

/// The kinds of cases that campaigns ask for.
enum class Profile {
  random,    ///< bodies as they come, moved and remodelled a few times
  hostile,   ///< vertices on planes, lines, nodes and beside them; extreme scales and offsets
  fed_back,  ///< output fed back many times, moved a little in between
  all        ///< one of these, by the seed
};

inline constexpr std::array<Named<Profile>, 4> kProfileNames = {{{"random", Profile::random},
                                                                 {"hostile", Profile::hostile},
                                                                 {"fed_back", Profile::fed_back},
                                                                 {"all", Profile::all}}};

/// One call of the tracker. `values` are its parameters by name, as a corpus file has them.
/// `advance` has motion, dt, the motion's own parameters, and for the motion `bodies` also seed and
/// speed. `displace` has those of a Perturbation. `remodel` and `improve` have none.
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
