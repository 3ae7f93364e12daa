// Seconds of one remodel, with its accuracy beside them: a CSV row a case on standard output.
// usage: remodel_bench [repetitions]
#include <fmt/core.h>

#include <algorithm>
#include <cstdlib>

#include "kernel/lists.h"
#include "kernel/measure/self_intersections.h"
#include "tests/models.h"
#include "tests/surgery/exact_union.h"
#include "tests/surgery/support.h"

using namespace suture;
using namespace suture::surgery;

namespace {

struct Case {
  std::string name;
  Triangles first, second;
};

std::vector<Case> cases() {
  std::vector<Case> all;
  if (auto horse = classic("horse.ply")) {
    for (Triangle& t : horse->triangles) std::swap(t[0], t[1]);  // the scan is inside-out
    const Box box = bounding_box(horse->positions);
    all.push_back(
        {"two horses", *horse,
         translated(*horse, (box.high - box.low).cwiseProduct(Point(0.013, 0.007, 0.021)))});
  }
  const Triangles legs = animal({Point::Zero(), 1, 0.035, 0.01});
  all.push_back({"two animals", legs, translated(legs, {0.02, 0.01, 0.015})});
  all.push_back({"two balls", ball(1, {0.013, 0.007, 0.003}, 32), ball(1, {1.2, 0.3, 0.1}, 32)});
  return all;
}

void run(const Case& c, int cells, Arithmetic arithmetic, int repetitions) {
  const Triangles two = together(c.first, c.second);
  const Box box = bounding_box(two.positions);
  const TrackerOptions options{.cell_size = (box.high - box.low).maxCoeff() / cells,
                               .arithmetic = arithmetic};
  std::vector<double> seconds;
  SurgeryReport report;
  Triangles result;
  for (int r = 0; r < repetitions; ++r) {
    Tracker tracker(two, options);
    Stopwatch watch;
    report = tracker.remodel();
    seconds.push_back(watch.lap());
    result = tracker.surface();
  }
  fmt::print("{},{},{},{},{:.3f},{:.3f},{:.3e},{},{},{},{},{}\n", c.name,
             arithmetic == Arithmetic::filtered ? "filtered" : "rational", two.triangles.size(),
             cells, median(seconds), *std::min_element(seconds.begin(), seconds.end()),
             volume(result) / exact_union_volume(c.first, c.second) - 1, report.components_after,
             report.euler_after, self_intersections(two).pairs.size(),
             self_intersections(result).pairs.size(), result.triangles.size());
}

}  // namespace

int main(int count, char** arguments) {
  const int repetitions = count > 1 ? std::max(1, std::atoi(arguments[1])) : 5;
  fmt::print(
      "case,arithmetic,triangles,cells,seconds_median,seconds_least,volume_error,components,euler,"
      "self_intersections_before,self_intersections_after,triangles_after\n");
  for (const Case& c : cases())
    for (const int cells : {64, 128, 192}) run(c, cells, Arithmetic::filtered, repetitions);
  const Case balls = cases().back();
  run(balls, 64, Arithmetic::rational, 1);
}
