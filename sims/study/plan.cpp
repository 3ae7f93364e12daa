// Which runs a study makes of a scene: factors, their levels, and the designs that combine them.
#include "sims/study/plan.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <set>

#include "kernel/errors.h"
#include "surgery/model/option_table.h"

namespace suture::sims {
namespace {

/// The whole of `text` as a number, if it is one.
std::optional<double> number(const std::string& text) {
  if (text.empty() || std::isspace(static_cast<unsigned char>(text[0])) != 0) return {};
  char* end = nullptr;
  const double x = std::strtod(text.c_str(), &end);
  if (*end != 0 || !std::isfinite(x)) return {};
  return x;
}

Value value_from(const std::string& text) {
  if (text == "true" || text == "false") return text == "true";
  const auto x = number(text);
  if (!x) return text;
  constexpr double most = 1e15;  // whole numbers up to here are exact
  if (text.find_first_not_of("+-0123456789") == std::string::npos && std::abs(*x) < most)
    return static_cast<std::int64_t>(*x);
  return *x;
}

std::optional<double> as_number(const Value& value) {
  if (const auto* i = std::get_if<std::int64_t>(&value)) return static_cast<double>(*i);
  if (const auto* d = std::get_if<double>(&value)) return *d;
  return {};
}

Value product(const Value& own, const Value& times) {
  const double x = as_number(own).value() * as_number(times).value();
  if (!std::holds_alternative<std::int64_t>(own)) return rounded_for_people(x);
  return static_cast<std::int64_t>(std::llround(x));
}

Level read_level(const Factor& factor, const std::string& text, const Settings& own) {
  if (text.size() < 2 || text[0] != 'x' || !number(text.substr(1)))
    return {value_from(text), factor.name == "resolution"};
  const Level level{value_from(text.substr(1)), true};
  if (!as_number(setting(own, factor.settings.front()).value))
    throw InvalidInput(
        fmt::format("factor {}: {} is a multiple, but the setting is no number; "
                    "give values",
                    factor.name, text));
  return level;
}

/// The factor that varies a choice: every word of it but the scene's own.
template <class Options>
std::string all_but(const Settings& own, const std::string& key,
                    const OptionTable<Options>& table) {
  const std::string now = text_of(setting(own, key).value);
  std::vector<std::string> others;
  for (const std::string& name : table.row(key).about.choices)
    if (name != now) others.push_back(name);
  return key + "=" + fmt::format("{}", fmt::join(others, ","));
}

/// The steps between two remodels that last as long as `every` steps of the scene's own length.
Value kept_interval(const Value& every, double own_step, double step) {
  const auto steps = std::get<std::int64_t>(every);
  const double same = static_cast<double>(steps) * own_step / step;
  if (steps == 0 || !(same < 1e9)) return every;
  return std::max<std::int64_t>(1, std::llround(same));
}

/// The changes of the scene where factors[i] is at its level choice[i].
SceneChanges combined(const Settings& own, const std::vector<Factor>& factors,
                      const std::vector<std::size_t>& choice) {
  SceneChanges changes;
  for (const bool together : {false, true})  // resolution multiplies what the others set
    for (std::size_t i = 0; i < factors.size(); ++i) {
      const Level& level = factors[i].levels[choice[i]];
      if ((factors[i].name == "resolution") != together) continue;
      for (const std::string& name : factors[i].settings) {
        const auto at = changes.find(name);
        const Value& now = at == changes.end() ? setting(own, name).value : at->second;
        const Value next = level.multiple ? product(now, level.value) : level.value;
        changes.insert_or_assign(name, next);
      }
    }
  if (const auto at = changes.find("time.step"); at != changes.end()) {
    const double own_step = as_number(setting(own, "time.step").value).value();
    const double step = as_number(at->second).value_or(0);
    for (const char* name : {"time.remodel_every", "time.improve_every"})
      if (step > 0)
        changes.try_emplace(name, kept_interval(setting(own, name).value, own_step, step));
  }
  std::erase_if(changes, [&](const auto& change) {
    return text_of(change.second) == text_of(setting(own, change.first).value);
  });
  return changes;
}

/// Runs in the order in which they were asked for, each once.
class Plan {
 public:
  explicit Plan(const Settings& own) : own_(own) {}

  void add(SceneChanges changes, const std::string& design) {
    if (!seen_.insert(words_of(own_, changes)).second) return;
    runs_.push_back({std::move(changes), design});
    if (runs_.size() > kMostRuns)
      throw InvalidInput(
          fmt::format("these factors ask for more than {} runs; give fewer levels, or --design one",
                      kMostRuns));
  }
  std::vector<PlannedRun> take() { return std::move(runs_); }

 private:
  const Settings& own_;
  std::set<std::string> seen_;
  std::vector<PlannedRun> runs_;
};

}  // namespace

double rounded_for_people(double x) {
  return std::strtod(fmt::format("{:.6g}", x).c_str(), nullptr);
}

Factor read_factor(const std::string& text, const Settings& own) {
  const std::size_t equals = text.find('=');
  if (equals == std::string::npos || equals == 0 || equals + 1 == text.size())
    throw InvalidInput("factor \"" + text + "\": write name=value,value,..., as in " +
                       "cell_size=x0.5,x1 or collapse=straighten,keep");
  Factor factor{text.substr(0, equals), {}, {}};
  if (factor.name == "resolution")
    factor.settings = {"tracker.cell_size", "quality.edge_length"};
  else
    factor.settings = {setting(own, factor.name).full()};
  if (factor.settings.front() == "time.end" ||
      std::holds_alternative<std::vector<double>>(setting(own, factor.settings.front()).value))
    throw InvalidInput("factor " + factor.name +
                       ": it cannot be varied, as results would not be comparable; make a scene "
                       "for each value");
  for (std::size_t from = equals + 1; from <= text.size();) {
    const std::size_t to = std::min(text.find(',', from), text.size());
    if (to == from)
      throw InvalidInput("factor \"" + text + "\": a value between two commas is missing");
    factor.levels.push_back(read_level(factor, text.substr(from, to - from), own));
    if (factor.name == "resolution" && !(as_number(factor.levels.back().value).value_or(0) > 0))
      throw InvalidInput(
          "factor resolution: give multiples above 0 of the scene's own, as in x0.7");
    from = to + 1;
  }
  return factor;
}

std::vector<Design> designs_of(const std::vector<std::string>& factors, const Settings& own,
                               const DesignChoice& choice) {
  Design grid{"grid", {}};
  for (const std::string& text : factors) {
    grid.factors.push_back(read_factor(text, own));
    for (std::size_t i = 0; i + 1 < grid.factors.size(); ++i)
      if (grid.factors[i].settings == grid.factors.back().settings)
        throw InvalidInput("factor " + grid.factors[i].name +
                           " is given twice; give all its values at once");
  }
  std::vector<Design> designs;
  if (choice.one)
    for (const Factor& factor : grid.factors) designs.push_back({factor.name, {factor}});
  if (choice.grid) designs.push_back(std::move(grid));
  return designs;
}

std::vector<Design> default_designs(const Settings& own, const DesignChoice& choice) {
  std::vector<std::string> alone = {all_but(own, "arithmetic", tracker_options()),
                                    all_but(own, "collapse", tracker_options()),
                                    all_but(own, "placement", tracker_options()),
                                    "cell_size=x0.5,x2",
                                    "resolution=x0.7,x1.4,x2",
                                    "step=x0.5,x2,x4",
                                    "remodel_every=x2,x5,x10"};
  if (text_of(setting(own, "improve_every").value) != "0")
    for (const std::string& improvement :
         {std::string("edge_length=x0.7,x1.4"), all_but(own, "subdivision", quality_options()),
          std::string("improve_every=0,x5"), std::string("passes=1"),
          std::string("volume_bound=x0.1,x10"), std::string("smallest_angle=5,25"),
          std::string("largest_angle=130,170")})
      alone.push_back(improvement);
  std::vector<Design> designs;
  if (choice.one) {
    designs = designs_of(alone, own, {.one = true, .grid = false});
    designs.push_back(
        {"arithmetic", {read_factor("arithmetic=rounded", own), read_factor("jitter=0", own)}});
  }
  if (choice.grid)
    designs.push_back(designs_of({"resolution=x1,x1.4,x2", "step=x1,x2,x4", "remodel_every=x1,x5"},
                                 own, {.one = false, .grid = true})
                          .front());
  return designs;
}

std::vector<PlannedRun> plan(const Settings& own, const std::vector<Design>& designs) {
  Plan plan(own);
  plan.add({}, "own");
  for (const Design& design : designs) {
    std::vector<std::size_t> choice(design.factors.size(), 0);
    for (bool more = !choice.empty(); more;) {
      plan.add(combined(own, design.factors, choice), design.name);
      more = false;
      for (std::size_t i = choice.size(); i-- > 0 && !more;) {
        more = ++choice[i] < design.factors[i].levels.size();
        if (!more) choice[i] = 0;
      }
    }
  }
  return plan.take();
}

}  // namespace suture::sims
