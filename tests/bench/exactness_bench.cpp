// What exact predicates cost: arithmetics side by side in one process, over whole remodels and
// single calls; a CSV row a comparison on standard output.
// usage: exactness_bench [rounds] > papers/results/exactness.csv
#include <fmt/core.h>

#include <algorithm>
#include <cstdlib>
#include <ctime>
#include <map>

#include "kernel/random.h"
#include "sims/driver/scene_steps.h"
#include "tests/models.h"
#include "tests/paths.h"
#include "tests/surgery/support.h"

using namespace suture;
using namespace suture::surgery;
using namespace suture::sims;

namespace {

struct Input {
  std::string name;
  Triangles surface;
  TrackerOptions options;
};

/// One arithmetic as it is compared: plain doubles come with the paper's jitter and without.
struct Contestant {
  const char* name;
  Arithmetic arithmetic;
  bool jitter;
};
constexpr Contestant kContestants[] = {{"filtered", Arithmetic::filtered, false},
                                       {"rounded", Arithmetic::rounded, false},
                                       {"rounded, jittered", Arithmetic::rounded, true},
                                       {"rational", Arithmetic::rational, false}};
constexpr int kRationalRounds = 3;  // it takes several times as long as the others

double cpu_seconds() {
  timespec now{};
  clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

TrackerOptions cells_across(const Triangles& surface, int cells) {
  const Box box = bounding_box(surface.positions);
  return {.cell_size = (box.high - box.low).maxCoeff() / cells};
}

Triangles two_balls(int frequency) {
  return together(ball(1, {0.013, 0.007, 0.003}, frequency), ball(1, {1.2, 0.3, 0.1}, frequency));
}

Triangles two_horses() {
  auto horse = classic("horse.ply");
  if (!horse) {
    fmt::print(stderr, "the horse is not at hand: animals of our own take its place\n");
    const Triangles legs = animal({Point::Zero(), 1, 0.035, 0.006});
    return together(legs, translated(legs, {0.02, 0.01, 0.015}));
  }
  for (Triangle& t : horse->triangles) std::swap(t[0], t[1]);  // the scan is inside-out
  const Box box = bounding_box(horse->positions);
  const Point size = box.high - box.low;
  return together(*horse, translated(*horse, size.cwiseProduct(Point(0.013, 0.007, 0.021))));
}

/// Every vertex on a node of the lattice, and faces of the two bodies in one plane.
Input aligned_boxes() {
  const Triangles cube = box({Point::Zero(), Point::Constant(1), 1.0 / 64});
  return {"aligned boxes",
          together(cube, translated(cube, Point(0.5, 0.25, 0))),
          {.cell_size = 1.0 / 64}};
}

/// A remodel's result, which has vertices on the lattice, meets another ball.
Input fed_back() {
  const Triangles two = two_balls(40);
  const TrackerOptions options = cells_across(two, 64);
  Tracker tracker(two, options);
  tracker.remodel();
  return {"output fed back", together(tracker.surface(), ball(0.8, {0.61, -0.3, 0.9}, 32)),
          options};
}

Input late_curl_noise() {
  Scene scene = read_scene(std::filesystem::path(source_dir()) / "data/scenes/curl_noise.toml");
  SceneSteps steps(scene);
  StepWatcher nobody;
  while (steps.index() < 120) steps.step(nobody);
  return {"curl noise, step 120", steps.surface(), scene.tracker};
}

std::vector<Input> inputs() {
  std::vector<Input> all;
  const Triangles small = two_balls(22), large = two_balls(71), horses = two_horses();
  all.push_back({"two balls, 20k triangles", small, cells_across(small, 64)});
  all.push_back({"two balls, 200k triangles", large, cells_across(large, 128)});
  all.push_back({"two horses, 128 cells", horses, cells_across(horses, 128)});
  all.push_back(aligned_boxes());
  all.push_back(fed_back());
  all.push_back(late_curl_noise());
  return all;
}

struct Quartiles {
  double low, middle, high;
};

Quartiles quartiles(std::vector<double> values) {
  std::sort(values.begin(), values.end());
  const auto at = [&](double share) {
    return values[static_cast<std::size_t>(share * static_cast<double>(values.size() - 1) + 0.5)];
  };
  return {at(0.25), at(0.5), at(0.75)};
}

constexpr const char* kOutcomes[] = {"unchanged", "committed", "refused"};

/// One contestant's rounds on one input.
struct Rounds {
  std::vector<double> seconds;
  std::string outcome;
  std::uint64_t calls = 0, failures = 0;
};

void heading() {
  fmt::print(
      "what,input,triangles,arithmetic,outcome,rounds,median,unit,ratio_to_rounded,ratio_low,"
      "ratio_high,ratio_to_jittered,predicate_calls,filter_failures\n");
}

/// The median of one's ratios to another round by round, and with `spread` the quartiles beside it;
/// empty where only one of them was refused, since that leaves most of the work undone.
std::string ratios(const Rounds& of, const Rounds& to, bool spread) {
  std::vector<double> all;
  for (std::size_t i = 0; i < std::min(of.seconds.size(), to.seconds.size()); ++i)
    all.push_back(of.seconds[i] / to.seconds[i]);
  if (all.empty() || (of.outcome == "refused") != (to.outcome == "refused"))
    return spread ? ",," : "";
  const Quartiles q = quartiles(all);
  return spread ? fmt::format("{:.3f},{:.3f},{:.3f}", q.middle, q.low, q.high)
                : fmt::format("{:.3f}", q.middle);
}

/// Prints each contestant, and the quartiles of its ratios to plain doubles round by round.
void print(const std::string& what, const std::string& input, std::size_t triangles,
           const std::map<std::string, Rounds>& all, const char* unit, double scale) {
  const auto at = all.find("rounded, jittered");
  const Rounds jittered = at == all.end() ? Rounds{} : at->second;
  for (const auto& [name, rounds] : all) {
    fmt::print("{},\"{}\",{},\"{}\",{},{},{:.4g},{},{},{},{},{}\n", what, input, triangles, name,
               rounds.outcome, rounds.seconds.size(), scale * quartiles(rounds.seconds).middle,
               unit, ratios(rounds, all.at("rounded"), true), ratios(rounds, jittered, false),
               rounds.calls, rounds.failures);
  }
}

void remodel_round(const Input& input, const Contestant& c, Rounds& rounds) {
  TrackerOptions options = input.options;
  options.arithmetic = c.arithmetic;
  if (!c.jitter) options.jitter = 0;
  Tracker tracker(input.surface, options);
  const double before = cpu_seconds();
  const SurgeryReport report = tracker.remodel();
  rounds.seconds.push_back(cpu_seconds() - before);
  rounds.outcome = kOutcomes[static_cast<int>(report.outcome)];
  const OracleCounts& n = report.oracle;
  rounds.calls = n.edge_side + n.triangle_side + n.orientation;
  rounds.failures = n.filter_failures;
}

/// All contestants in turn, in an order that turns from round to round; the first round is not
/// counted.
void remodels(const Input& input, int count) {
  std::map<std::string, Rounds> all;
  constexpr int most = std::size(kContestants);
  for (int round = -1; round < count; ++round) {
    for (int i = 0; i < most; ++i) {
      const Contestant& c = kContestants[(i + round + most) % most];
      if (c.arithmetic == Arithmetic::rational && (round < 0 || round >= kRationalRounds)) continue;
      Rounds unused;
      remodel_round(input, c, round < 0 ? unused : all[c.name]);
    }
  }
  print("remodel", input.name, input.surface.triangles.size(), all, "s", 1);
}

/// Questions as remodels ask them: triangles of the size of a cell, and nodes and lines near them.
struct Question {
  Point a, b, c, node;
};

std::vector<Question> questions(bool on_the_lattice) {
  Random random(7);
  const auto point = [&](double reach) {
    Point p{random.uniform(0, reach), random.uniform(0, reach), random.uniform(0, reach)};
    if (on_the_lattice) p = (p * 4).array().round() / 4;
    return p;
  };
  std::vector<Question> all;
  for (int i = 0; i < 4096; ++i) {
    const Point corner = point(30);
    all.push_back({corner + point(1), corner + point(1), corner + point(1), corner + point(1)});
  }
  return all;
}

using Call = int (*)(const Oracle&, const Question&);

void calls(const std::string& name, Call call, bool on_the_lattice, int count) {
  const std::vector<Question> asked = questions(on_the_lattice);
  std::map<std::string, Rounds> all;
  int sum = 0;  // so that no call is left out
  for (int round = -1; round < count; ++round)
    for (const Contestant& c : kContestants) {
      const bool slow = c.arithmetic == Arithmetic::rational;
      if (c.jitter || (slow && round >= kRationalRounds)) continue;
      const auto oracle = make_oracle(c.arithmetic);
      const OracleTally tally;
      const int times = slow ? 1 : 200;
      const double before = cpu_seconds();
      for (int i = 0; i < times; ++i)
        for (const Question& q : asked) sum += call(*oracle, q);
      const double each = (cpu_seconds() - before) / (times * static_cast<double>(asked.size()));
      if (round < 0) continue;
      Rounds& rounds = all[c.name];
      rounds.seconds.push_back(each);
      rounds.outcome = "answered";
      rounds.calls = static_cast<std::uint64_t>(times) * asked.size();
      rounds.failures = tally.counts().filter_failures;
    }
  if (sum == 1 << 30) fmt::print(stderr, "unlikely\n");
  print("call", name + (on_the_lattice ? ", on the lattice" : ", random"), 0, all, "ns", 1e9);
}

}  // namespace

int main(int count, char** arguments) {
  const int rounds = count > 1 ? std::max(1, std::atoi(arguments[1])) : 15;
  heading();
  for (const Input& input : inputs()) remodels(input, rounds);
  for (const bool on_the_lattice : {false, true}) {
    calls(
        "edge_side",
        [](const Oracle& o, const Question& q) {
          return o.edge_side(q.a, q.b, {0, 1, q.node[0], q.node[1]});
        },
        on_the_lattice, rounds);
    calls(
        "triangle_side",
        [](const Oracle& o, const Question& q) { return o.triangle_side(q.a, q.b, q.c, q.node); },
        on_the_lattice, rounds);
    calls(
        "orientation",
        [](const Oracle& o, const Question& q) { return o.orientation(q.a, q.b, q.c, q.node); },
        on_the_lattice, rounds);
  }
}
