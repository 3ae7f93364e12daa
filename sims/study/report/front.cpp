// Errors and costs of a study's runs, and the runs that no other beats in both.
#include "sims/study/report/front.h"

#include <algorithm>
#include <cmath>
#include <tuple>

namespace suture::sims {

std::vector<std::size_t> pareto_front(const std::vector<Row>& rows, const Criterion& error,
                                      const Criterion& cost) {
  std::vector<std::tuple<double, double, std::size_t>> points;
  for (std::size_t i = 0; i < rows.size(); ++i) {
    const double c = cost.of(rows[i], 1), e = error.of(rows[i], 1);
    if (sound(rows[i]) && !std::isnan(c) && !std::isnan(e)) points.emplace_back(c, e, i);
  }
  std::sort(points.begin(), points.end());
  std::vector<std::size_t> front;
  double least = std::numeric_limits<double>::infinity();
  for (const auto& [c, e, i] : points) {
    if (!(e < least)) continue;
    least = e;
    front.push_back(i);
  }
  return front;
}

}  // namespace suture::sims
