// The oracles: what must hold after every operation, each with its name and its reason.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "kernel/lattice.h"
#include "kernel/triangles.h"
#include "surgery/model/options.h"
#include "surgery/model/report.h"

namespace suture::sims {

/// One call of the tracker, seen from outside.
struct Observation {
  std::uint64_t seed = 0;
  const TrackerOptions& options;
  const Triangles& before;
  const Triangles& after;
  const SurgeryReport* surgery = nullptr;  ///< of a remodel
  const QualityReport* quality = nullptr;  ///< of an improvement
  bool moved = true;  ///< whether anything but a committed remodel came just before
};

/// What is wrong, in one line; nothing if nothing is.
using Objection = std::optional<std::string>;

struct FuzzOracle {
  const char* name;
  bool fast;  ///< asked always; the others on one seed in kSampled, unless they are named
  Objection (*object)(const Observation&);
};

/// All of them but those that the runner itself sees: exception, refused, crash, hang.
const std::vector<FuzzOracle>& fuzz_oracles();

/// Which oracles a campaign asks: "sampled" (the fast ones always, the others on one seed in 64, by
/// the seed), "fast", "all", or names joined by commas, which are then asked always.
class OracleChoice {
 public:
  /// \throw InvalidInput for a name that is not known
  explicit OracleChoice(const std::string& words = "sampled");

  bool asks(const FuzzOracle& oracle, std::uint64_t seed) const;
  const std::string& words() const { return words_; }

 private:
  std::string words_;
  std::vector<std::string> names_;
};

/// Whether the solid angle at a node is 4π times its winding. \pre the node is not near the surface
Objection compare_winding(const Triangles& surface, const Lattice& lattice, const Index3& node,
                          int winding);

// Each below says in its source what it promises and why; all return nothing where they do not
// apply.
Objection object_audit(const Observation& o);
Objection object_bits(const Observation& o);
Objection object_map(const Observation& o);
Objection object_marches(const Observation& o);
Objection object_invariance(const Observation& o);
Objection object_settled(const Observation& o);
Objection object_solid_angle(const Observation& o);
Objection object_rational(const Observation& o);
Objection object_scaling(const Observation& o);
Objection object_axes(const Observation& o);
Objection object_cells(const Observation& o);
Objection object_order(const Observation& o);

}  // namespace suture::sims
