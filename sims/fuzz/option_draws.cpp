// Options are set through their tables, so that a word which a table gains is drawn as well.
#include "sims/fuzz/option_draws.h"

#include <cmath>

#include "sims/fuzz/named_options.h"

namespace suture::sims {

namespace {

constexpr const char* kCurvature = "curvature";  // two options that only do something together
constexpr const char* kBounds = "bounds";        // one case in four changes all bounds of quality

double any_cell_size(const Draws& d, CaseSize size) {
  const double whole = std::ldexp(1.0, -(size == CaseSize::large ? d.whole("large exponent", 1, 4)
                                                                 : d.whole("exponent", 1, 2)));
  return d.once_in("no power of two", 3) ? whole * d.uniform("factor", 0.8, 1.6) : whole;
}

/// A value for one option by its distribution.
struct AnyValue {
  const OptionInfo& option;
  Draws draws;
  double cell;

  Value operator()(CellSize) const { return cell; }
  Value operator()(Diagonal) const {
    return std::vector<double>(3, draws.uniform("value", 0, cell));
  }
  Value operator()(AnyWord) const { return draws.choice("value", option.choices); }
  Value operator()(OnlyWord only) const { return std::string(only.word); }
  Value operator()(Switched) const { return !std::get<bool>(option.usual.value()); }
  Value operator()(Whole w) const {
    return static_cast<std::int64_t>(draws.whole("value", w.low, w.high));
  }
  Value operator()(Uniform u) const { return draws.uniform("value", u.low, u.high); }
  Value operator()(UniformCells u) const { return cell * draws.uniform("value", u.low, u.high); }
};

}  // namespace

const std::vector<OptionDraw>& option_draws() {
  static const std::vector<OptionDraw> all = {
      {"tracker.cell_size", CellSize{}},
      {"tracker.origin", Diagonal{}, 4},
      {"tracker.events", AnyWord{}, 3},
      {"tracker.cell_test", OnlyWord{"plain"}, 4},
      {"tracker.depth", Whole{0, 2}, 2},
      {"tracker.collapse", AnyWord{}},
      {"tracker.placement", AnyWord{}},
      {"tracker.straighten_turn", Uniform{0, 180}, 8},
      {"quality.edge_length", UniformCells{0.5, 2.5}, 2},
      {"quality.keep_features", Switched{}, 2},
      {"quality.subdivision", AnyWord{}},
      {"quality.passes", Whole{1, 3}},
      {"quality.chord_error", UniformCells{0.001, 0.2}, 3, kCurvature},
      {"quality.finest", Uniform{0.2, 1}, 3, kCurvature},
      {"quality.longest", Uniform{1.2, 2}, 4, kBounds},
      {"quality.shortest", Uniform{0.1, 0.6}, 4, kBounds},
      {"quality.smallest_angle", Uniform{0, 30}, 4, kBounds},
      {"quality.largest_angle", Uniform{110, 179}, 4, kBounds},
      {"quality.volume_bound", Uniform{0, 0.2}, 4, kBounds},
      {"quality.turn_bound", Uniform{10, 90}, 4, kBounds},
      {"quality.feature_angle", Uniform{10, 90}, 4, kBounds}};
  return all;
}

const std::vector<OptionNotDrawn>& options_not_drawn() {
  static const std::vector<OptionNotDrawn> all = {
      {"tracker.arithmetic", "a campaign asks for one: only exact ones keep the promises"},
      {"tracker.jitter", "a campaign asks for it: it does something with rounded arithmetic only"},
      {"tracker.most_restarts", "it bounds the time of a remodel, which the fuzzer bounds itself"}};
  return all;
}

TrackerOptions draw_options(const Draws& draws, const std::vector<OptionDraw>& how, CaseSize size) {
  const double cell = any_cell_size(draws.in("cell_size"), size);
  TrackerOptions options;
  for (const OptionDraw& row : how) {
    const Draws own = draws.in(row.option);
    const Draws coin = row.together.empty() ? own : draws.in(row.together);
    if (!coin.once_in("drawn", row.once_in)) continue;
    set_option(options, row.option,
               std::visit(AnyValue{option_named(row.option), own, cell}, row.how));
  }
  return options;
}

}  // namespace suture::sims
