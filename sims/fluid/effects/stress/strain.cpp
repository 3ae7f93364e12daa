// The elastic strain that a liquid carries with it.
#include "sims/fluid/effects/stress/strain.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <utility>

#include "sims/fluid/grid/grid_corners.h"
#include "sims/fluid/velocity/advect_velocity.h"

namespace suture::sims {
namespace {

/// The place within its cell of the components that known[place] marks: cells' middles, and edges
/// along an axis.
std::array<double, 3> within(int place) {
  if (place == 0) return {0.5, 0.5, 0.5};
  std::array<double, 3> w{};
  w[place - 1] = 0.5;
  return w;
}

Point position(const SparseGrid& grid, int place, Slot s) {
  const Index3 c = grid.cell(s);
  const std::array<double, 3> w = within(place);
  return grid.origin() + grid.h() * Point(c[0] + w[0], c[1] + w[1], c[2] + w[2]);
}

/// A place that has components of a strain: the middle of a cell (kind 0) or of one of its edges
/// along an axis (kind 1 + axis).
struct Place {
  int kind;
  Slot slot;
};

/// Calls visit(component) with those at a place.
template <class Visit>
void for_each_component(int place, Visit visit) {
  for (int c = place == 0 ? 0 : place + 2; c < (place == 0 ? 3 : place + 3); ++c) visit(c);
}

/// Row and column of a component.
std::pair<int, int> entry(int component) {
  if (component < 3) return {component, component};
  return {next_axis(component - 3), prev_axis(component - 3)};
}

/// Four cells in a row along an axis, of which s is the one with number `own`.
std::array<Slot, 4> row(const SparseGrid& grid, Slot s, int axis, int own) {
  std::array<Slot, 4> cells;
  cells.fill(kNoSlot);
  cells[own] = s;
  for (int n = own; n > 0 && cells[n] != kNoSlot; --n)
    cells[n - 1] = grid.neighbour(cells[n], axis, -1);
  for (int n = own; n < 3 && cells[n] != kNoSlot; ++n)
    cells[n + 1] = grid.neighbour(cells[n], axis, 1);
  return cells;
}

/// The places of one kind round one of another, which are half a cell off along two axes: of four
/// rows and columns of four, where all 16 are known, else of the middle four those that are.
struct PlacesRound {
  std::array<Slot, 16> slots;
  std::array<double, 16> weights{};

  /// `to`: the kind of the other ones.
  PlacesRound(const Strain& strain, const Place& from, int to) {
    const std::array<double, 3> own = within(from.kind), other = within(to);
    int first = 0, second = 2;
    while (own[first] == other[first]) ++first;
    while (own[second] == other[second]) --second;
    bool all = true;
    const auto rows = row(*strain.grid, from.slot, first, own[first] > 0 ? 1 : 2);
    for (int i = 0; i < 4; ++i) {
      std::array<Slot, 4> cells;
      cells.fill(kNoSlot);
      if (rows[i] != kNoSlot) cells = row(*strain.grid, rows[i], second, own[second] > 0 ? 1 : 2);
      for (int j = 0; j < 4; ++j) {
        const bool known = cells[j] != kNoSlot && strain.known[to][cells[j]] != 0;
        slots[4 * i + j] = known ? cells[j] : kNoSlot;
        all = all && known;
      }
    }
    constexpr std::array<double, 4> cubic{-1.0 / 16, 9.0 / 16, 9.0 / 16, -1.0 / 16};
    double sum = 0;
    for (int n = 0; n < 16; ++n) {
      const bool middle = n / 4 % 3 != 0 && n % 4 % 3 != 0;
      if (all)
        weights[n] = cubic[n / 4] * cubic[n % 4];
      else if (middle && slots[n] != kNoSlot)
        weights[n] = 1;
      sum += weights[n];
    }
    for (double& w : weights) w = sum > 0 ? w / sum : 0;
  }

  double mean(const std::vector<double>& values) const {
    double sum = 0;
    for (int n = 0; n < 16; ++n)
      if (weights[n] != 0) sum += weights[n] * values[slots[n]];
    return sum;
  }
};

/// The whole tensor at a place, of which the other places' components are means there of the fourth
/// order: those of the second would turn what changes within some cells too little.
Eigen::Matrix3d tensor_at(const Strain& strain, int place, Slot s) {
  Eigen::Matrix3d t;
  const auto set = [&](int c, double value) {
    const auto [i, j] = entry(c);
    t(i, j) = t(j, i) = value;
  };
  for (int other = 0; other < 4; ++other) {
    if (other == place) {
      for_each_component(place, [&](int c) { set(c, strain.elastic.part(c)[s]); });
    } else {
      const PlacesRound round(strain, {place, s}, other);
      for_each_component(other, [&](int c) { set(c, round.mean(strain.elastic.part(c))); });
    }
  }
  return t;
}

/// Half the curl at p, over a cell.
Point spin(const MacVelocity& u, const Point& p) {
  const double h = u.grid->h();
  const auto slope = [&](int of, int along) {
    const Point step = h / 2 * Point::Unit(along);
    const double here = u.component(of, p);
    return (u.component(of, p + step, here) - u.component(of, p - step, here)) / h;
  };
  return 0.5 *
         Point(slope(2, 1) - slope(1, 2), slope(0, 2) - slope(2, 0), slope(1, 0) - slope(0, 1));
}

/// A smooth vector field at the cells that a strain's places touch, and on edges the mean of these:
/// following paths costs the most here, and they need not be followed from each place by itself.
class CellField {
 public:
  template <class Value>
  CellField(const Strain& strain, Value value)
      : grid_(*strain.grid), values_(grid_.size()), made_(strain.known[0]) {
    for (Slot s = 0; s < grid_.size(); ++s)
      for (int a = 0; a < 3; ++a)
        if (strain.known[1 + a][s] != 0)
          for (const Slot cell : cells_round_edge(grid_, a, s)) made_[cell] = 1;
    for (Slot s = 0; s < grid_.size(); ++s)
      if (made_[s] != 0) values_[s] = value(position(grid_, 0, s));
  }

  Point at(int place, Slot s) const {
    if (place == 0) return values_[s];
    Point sum = Point::Zero();
    int count = 0;
    for (const Slot cell : cells_round_edge(grid_, place - 1, s)) {
      sum += values_[cell];
      ++count;
    }
    return sum / count;
  }

 private:
  const SparseGrid& grid_;
  std::vector<Point> values_;
  std::vector<std::uint8_t> made_;
};

/// Each component changes by what the turn of the whole tensor there changes of it, so that what
/// does not turn is left as it is.
TensorField turned(const Strain& strain, const MacVelocity& u, double dt) {
  TensorField made = strain.elastic;
  const CellField angles(strain, [&](const Point& p) -> Point { return dt * spin(u, p); });
  for (int place = 0; place < 4; ++place)
    for (Slot s = 0; s < strain.grid->size(); ++s) {
      if (strain.known[place][s] == 0) continue;
      const Eigen::Matrix3d t = tensor_at(strain, place, s);
      const Point angle = angles.at(place, s);
      if (t.isZero(0) || angle.isZero(0)) continue;
      const Eigen::Matrix3d turn =
          Eigen::AngleAxisd(angle.norm(), angle.normalized()).toRotationMatrix();
      const Eigen::Matrix3d change = turn * t * turn.transpose() - t;
      for_each_component(place, [&](int c) {
        const auto [i, j] = entry(c);
        made.part(c)[s] += change(i, j);
      });
    }
  return made;
}

/// The starting points, on a grid, of the paths that lead to a strain's places.
struct PathStarts {
  const Strain& to;
  const SparseGrid& grid;
  CellField ways;  ///< from the places to where their paths begin

  GridCorners at(int place, Slot s) const {
    return {grid, within(place), position(*to.grid, place, s) + ways.at(place, s)};
  }
};

/// MacCormack's second pass, as for the velocity: `ahead` are where the paths lead that begin at
/// the places.
void correct(Strain& now, const Strain& old, const PathStarts& starts, const PathStarts& ahead) {
  const TensorField there = now.elastic;
  for (int place = 0; place < 4; ++place)
    for (Slot s = 0; s < now.grid->size(); ++s) {
      if (now.known[place][s] == 0) continue;
      const Slot before = old.grid->find(now.grid->cell(s));
      if (before == kNoSlot || old.known[place][before] == 0) continue;
      const GridCorners from = starts.at(place, s), to = ahead.at(place, s);
      for_each_component(place, [&](int c) {
        const auto bounds = from.bounds(old.elastic.part(c), old.known[place]);
        if (!bounds.any) return;
        const double was = old.elastic.part(c)[before];
        const double back = to.value(there.part(c), now.known[place], was);
        now.elastic.part(c)[s] =
            std::clamp(there.part(c)[s] + 0.5 * (was - back), bounds.low, bounds.high);
      });
    }
}

}  // namespace

Strain::Strain(SharedGrid g) : grid(std::move(g)) {
  elastic.fill(grid->size(), 0);
  for (auto& k : known) k.assign(grid->size(), 0);
}

std::size_t Strain::memory() const {
  std::size_t bytes = elastic.memory();
  for (const auto& k : known) bytes += k.capacity();
  return bytes;
}

Strain carried(const Strain& old, const MacVelocity& u, const Liquid& liquid, double dt) {
  if (!old.any()) return {};
  Strain turned_old = old;
  turned_old.elastic = turned(old, u, dt);
  Strain now(liquid.grid);
  const SparseGrid& grid = *now.grid;
  const VolumeFractions fractions = volume_fractions(liquid);
  for (int place = 0; place < 4; ++place) {
    const std::vector<float>& fraction = place == 0 ? fractions.cell : fractions.edge[place - 1];
    for (Slot s = 0; s < grid.size(); ++s) now.known[place][s] = fraction[s] > 0;
  }
  const auto ways = [&](double time) {
    return CellField(now, [&](const Point& p) -> Point { return path_start(u, p, time) - p; });
  };
  const PathStarts starts{now, *old.grid, ways(dt)};
  for (int place = 0; place < 4; ++place)
    for (Slot s = 0; s < grid.size(); ++s) {
      if (now.known[place][s] == 0) continue;
      const GridCorners from = starts.at(place, s);
      for_each_component(place, [&](int c) {
        now.elastic.part(c)[s] = from.value(turned_old.elastic.part(c), old.known[place], 0);
      });
    }
  correct(now, turned_old, starts, {now, grid, ways(-dt)});
  return now;
}

}  // namespace suture::sims
