// The variational projection, in the unknown q = p·dt/(density·h), which is a velocity.
#include "sims/fluid/velocity/pressure.h"

#include <algorithm>
#include <cmath>
#include <string>

#include "kernel/errors.h"

namespace suture::sims {
namespace {

/// How near to a cell's centre its surface may be, as a part of the way to the next: a row grows
/// with the reciprocal. The pressure this is off by is that of so small a part of a cell.
constexpr double kLeastWay = 1e-3;

[[noreturn]] void refuse(const char* what) { throw InvalidInput(std::string("pressure: ") + what); }

void check(const MacVelocity& velocity, const ProjectionInput& in) {
  if (!(in.density > 0) || !std::isfinite(in.density))
    refuse("the density must be finite and above 0");
  if (!(in.dt > 0) || !std::isfinite(in.dt)) refuse("the time step must be finite and above 0");
  const std::size_t size = in.liquid.distance.size();
  if (velocity.grid == nullptr || in.liquid.grid != velocity.grid || velocity.grid->size() != size)
    refuse("velocity and liquid must be on one grid");
  for (int a = 0; a < 3; ++a) {
    if (velocity.u[a].size() != size || velocity.known[a].size() != size)
      refuse("the velocity has not one value a face");
    if (in.solids.any() &&
        (in.solids.open[a].size() != size || in.solids.velocity[a].size() != size))
      refuse("the solids' faces are of another grid");
    if (in.jump != nullptr && (*in.jump)[a].size() != size)
      refuse("the pressure's jump has not one value a face");
  }
  if (in.divergence != nullptr && in.divergence->size() != size)
    refuse("the wanted divergence has not one value a cell");
}

/// One of a cell's six faces.
struct Face {
  int axis, side;  ///< −1: the low side
  Slot slot;       ///< of the face
  Slot other;      ///< the cell beyond it
};

class Projection {
 public:
  Projection(MacVelocity& velocity, const ProjectionInput& in)
      : velocity_(velocity),
        in_(in),
        liquid_(in.liquid),
        grid_(*velocity.grid),
        unit_(in.dt / (in.density * grid_.h())),
        matrix_(velocity.grid),
        right_(grid_.size(), 0),
        q_(grid_.size(), 0) {}

  SolveReport run(const SolverOptions& options) {
    for (Slot s = 0; s < grid_.size(); ++s)
      if (liquid_.inside(s)) add_row(s);
    close_sealed();
    take_from_right();
    std::vector<double> rest;
    const SolveReport report = solve(matrix_, right_, rest, options);
    for (Slot s = 0; s < q_.size(); ++s) q_[s] += rest[s];
    correct();
    return report;
  }

 private:
  Face face(Slot s, int axis, int side) const;
  template <class Visit>
  void visit_faces(Slot s, Visit visit) const {
    for (int axis = 0; axis < 3; ++axis)
      for (const int side : {-1, 1}) visit(face(s, axis, side));
  }
  /// The way from the centre of the cell inside to the surface, in cells.
  double way(const Face& f) const {
    return std::max(kLeastWay, liquid_.way_to_surface(f.axis, f.slot));
  }
  /// The liquid's q at the surface.
  double at_surface(const Face& f) const {
    return in_.jump == nullptr ? 0 : unit_ * (*in_.jump)[f.axis][f.slot];
  }
  double open_volume(Slot s) const;
  void add_row(Slot s);
  void close_sealed();
  void take_from_right();
  void correct();
  void correct_face(int axis, Slot s);

  MacVelocity& velocity_;
  const ProjectionInput& in_;
  const Liquid& liquid_;
  const SparseGrid& grid_;
  double unit_;  ///< the q of a pressure of 1
  SevenPoint matrix_;
  std::vector<double> right_, q_;
  std::vector<Slot> airy_;  ///< the cells with a face to air
};

Face Projection::face(Slot s, int axis, int side) const {
  const Slot other = grid_.neighbour(s, axis, side);
  if (other == kNoSlot)
    throw InvalidInput("pressure: the grid ends at a liquid cell; it needs a band of 1 or more");
  return {axis, side, side < 0 ? s : other, other};
}

/// How much of a cell no solid has: the middle one of what its pairs of faces leave open, which is
/// right for a plane across an axis.
double Projection::open_volume(Slot s) const {
  if (!in_.solids.any()) return 1;
  std::array<double, 3> open;
  for (int a = 0; a < 3; ++a)
    open[a] = (in_.solids.open[a][s] + in_.solids.open[a][grid_.neighbour(s, a, 1)]) / 2;
  std::sort(open.begin(), open.end());
  return open[1];
}

/// The row says what flows out of the cell: open·u + (1 − open)·u of the solid, u less the
/// difference of q.
void Projection::add_row(Slot s) {
  double diagonal = 0, right = 0;
  bool air = false;
  visit_faces(s, [&](const Face& f) {
    const double open = in_.solids.open_at(f.axis, f.slot);
    if (open < 1) right -= f.side * (1 - open) * in_.solids.velocity_at(f.axis, f.slot);
    if (open == 0) return;
    right -= f.side * open * velocity_.u[f.axis][f.slot];
    if (liquid_.inside(f.other)) {
      diagonal += open;
      if (f.side < 0) matrix_.low[f.axis][s] = -open;
    } else {
      air = true;
      diagonal += open / way(f);
      right += open / way(f) * at_surface(f);
    }
  });
  if (diagonal == 0) return;  // closed all round
  if (in_.divergence != nullptr) right += open_volume(s) * (*in_.divergence)[s] * grid_.h();
  if (!std::isfinite(right)) {
    const Point p = grid_.centre(grid_.cell(s));
    throw InvalidInput("pressure: what flows out of the cell at " + number(p[0]) + ", " +
                       number(p[1]) + ", " + number(p[2]) +
                       " is not finite; look at the velocities and forces there");
  }
  matrix_.active[s] = 1;
  matrix_.diagonal[s] = diagonal;
  right_[s] = right;
  if (air) airy_.push_back(s);
}

/// Liquid without air keeps its volume, and the level of its pressure means nothing: the right
/// sides of its cells get the sum 0, and one cell a spring to 0, which then has no force.
void Projection::close_sealed() {
  std::vector<std::uint8_t> seen(grid_.size(), 0);
  std::vector<Slot> part;
  const auto spread = [&](Slot from) {
    part.assign(1, from);
    seen[from] = 1;
    for (std::size_t n = 0; n < part.size(); ++n)
      visit_faces(part[n], [&](const Face& f) {
        if (matrix_.active[f.other] == 0 || seen[f.other] != 0) return;
        if (in_.solids.open_at(f.axis, f.slot) == 0) return;
        seen[f.other] = 1;
        part.push_back(f.other);
      });
  };
  for (const Slot s : airy_)
    if (seen[s] == 0) spread(s);
  for (Slot s = 0; s < grid_.size(); ++s) {
    if (matrix_.active[s] == 0 || seen[s] != 0) continue;
    spread(s);
    double sum = 0, weights = 0;
    Slot widest = s;
    for (const Slot n : part) {
      sum += right_[n];
      weights += matrix_.diagonal[n];
      if (matrix_.diagonal[n] > matrix_.diagonal[widest]) widest = n;
    }
    for (const Slot n : part) right_[n] -= sum * matrix_.diagonal[n] / weights;
    matrix_.diagonal[widest] *= 2;
  }
}

/// Starts cells at the surface from its own q: a jump over a short way makes a right side so large
/// that the solver's tolerance would mean nothing elsewhere.
void Projection::take_from_right() {
  if (in_.jump == nullptr) return;
  for (const Slot s : airy_) {
    double sum = 0, weights = 0;
    visit_faces(s, [&](const Face& f) {
      const double open = in_.solids.open_at(f.axis, f.slot);
      if (open == 0 || liquid_.inside(f.other)) return;
      sum += open / way(f) * at_surface(f);
      weights += open / way(f);
    });
    q_[s] = sum / weights;
  }
  for (const Slot s : airy_) {
    right_[s] -= matrix_.diagonal[s] * q_[s];
    visit_faces(s, [&](const Face& f) {
      if (!liquid_.inside(f.other)) return;
      right_[f.other] += in_.solids.open_at(f.axis, f.slot) * q_[s];
    });
  }
}

void Projection::correct_face(int axis, Slot s) {
  const Slot below = grid_.neighbour(s, axis, -1);
  if (below == kNoSlot) return;
  const bool up = liquid_.inside(s), down = liquid_.inside(below);
  if (!up && !down) return;
  double& u = velocity_.u[axis][s];
  if (in_.solids.open_at(axis, s) == 0) {
    if (matrix_.active[s] != 0 || matrix_.active[below] != 0) u = in_.solids.velocity_at(axis, s);
    return;
  }
  const Face f{axis, 0, s, kNoSlot};
  if (up && down)
    u -= q_[s] - q_[below];
  else if (up)
    u -= (q_[s] - at_surface(f)) / way(f);
  else
    u -= (at_surface(f) - q_[below]) / way(f);
  velocity_.known[axis][s] = 1;
}

void Projection::correct() {
  std::array<std::vector<Slot>, 3> free;  // faces of droplets, known as before
  for (const Slot s : liquid_.droplet_cells)
    visit_faces(s, [&](const Face& f) {
      if (velocity_.known[f.axis][f.slot] != 0) free[f.axis].push_back(f.slot);
    });
  for (int axis = 0; axis < 3; ++axis) {
    std::fill(velocity_.known[axis].begin(), velocity_.known[axis].end(), std::uint8_t{0});
    for (Slot s = 0; s < grid_.size(); ++s) correct_face(axis, s);
    for (const Slot s : free[axis])
      if (in_.solids.open_at(axis, s) > 0) velocity_.known[axis][s] = 1;
  }
}

}  // namespace

SolveReport project(MacVelocity& velocity, const ProjectionInput& input,
                    const SolverOptions& options) {
  check(velocity, input);
  return Projection(velocity, input).run(options);
}

}  // namespace suture::sims
