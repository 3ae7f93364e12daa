// How the tracker's options are drawn: one line for each, with its probability and its range.
#pragma once

#include <string>
#include <variant>
#include <vector>

#include "sims/fuzz/draws.h"
#include "sims/fuzz/generators.h"
#include "surgery/model/options.h"

namespace suture::sims {

/// The distributions of options.
struct CellSize {};  ///< 2 or 4 cells a unit (a large case: up to 16), in a third times 0.8 to 1.6
struct Diagonal {};  ///< a point on the cell's diagonal
struct AnyWord {};   ///< each of the option's words alike
struct OnlyWord {    ///< one word, which is not the default
  const char* word;
};
struct Switched {};  ///< the other than the default
struct Whole {
  int low, high;  ///< both included
};
struct Uniform {
  double low, high;
};
struct UniformCells {
  double low, high;  ///< in cells
};
using Distribution =
    std::variant<CellSize, Diagonal, AnyWord, OnlyWord, Switched, Whole, Uniform, UniformCells>;

/// An option is drawn in one case of `once_in`; in the others it keeps its default. Options that
/// name the same `together` are drawn in the same cases.
struct OptionDraw {
  std::string option;  ///< by its name in the tables of options, as "tracker.depth"
  Distribution how;
  std::uint64_t once_in = 1;
  std::string together{};
};

const std::vector<OptionDraw>& option_draws();

struct OptionNotDrawn {
  std::string option, reason;
};

const std::vector<OptionNotDrawn>& options_not_drawn();

/// Options for a case of that size. \throw InvalidInput if a table does not know a name
TrackerOptions draw_options(const Draws& draws, const std::vector<OptionDraw>& how, CaseSize size);

}  // namespace suture::sims
