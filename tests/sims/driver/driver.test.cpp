#include "sims/driver/driver.h"

#include <catch2/catch.hpp>
#include <string>

#include "kernel/errors.h"
#include "sims/baselines/level_set/level_set.h"
#include "sims/flows/fields.h"
#include "sims/flows/motions.h"
#include "sims/tracking/mesh_tracker.h"
#include "tests/sims/balls.h"

using namespace suture;
using namespace suture::sims;

namespace {

/// A tracker that writes down what it is told; of one triangle, until it is emptied.
class Told : public SurfaceTracker {
 public:
  Told(std::string& log, bool mesh) : log_(log), mesh_(mesh) { surface_.triangles.resize(1); }

  bool keeps_triangles() const override { return mesh_; }
  void advect(const VelocityField& /*u*/, double dt) override {
    log_ += 'a';
    time_ += dt;
  }
  SurgeryReport remodel() override {
    log_ += 'R';
    SurgeryReport report;
    report.outcome = outcome;
    if (vanishes) surface_ = {};
    return report;
  }
  QualityReport improve() override {
    log_ += 'I';
    return {};
  }
  void end_of_frame() override { log_ += 'E'; }
  const Triangles& surface() override { return surface_; }
  double distance(const Point& /*p*/) override { return 0; }
  double time() const override { return time_; }
  TrackerCost cost() const override { return {}; }

  Outcome outcome = Outcome::committed;
  bool vanishes = false;

 private:
  std::string& log_;
  bool mesh_;
  Triangles surface_;
  double time_ = 0;
};

/// A simulator and a watcher that write into the same log.
struct Moves : Simulator, StepWatcher {
  explicit Moves(std::string& text) : log(text) {}

  void step(SurfaceTracker& surface, double dt) override {
    dts.push_back(dt);
    surface.advect([](const Point&, double) { return Point(0, 0, 0); }, dt);
  }
  double longest_step() const override { return longest; }
  int most_steps() const override { return most; }
  bool wants_topology() const override { return wants; }
  void before_remodel(SurfaceTracker& /*surface*/) override { log += '<'; }
  void after_remodel(SurfaceTracker& /*surface*/) override { log += '>'; }
  void surface_changed(const Triangles& /*surface*/,
                       const std::vector<std::uint32_t>& /*vertex_map*/) override {
    log += 'c';
  }
  void moved(double /*dt*/) override { log += 'm'; }
  void remodelled(const SurgeryReport& /*report*/) override { log += 'r'; }
  void improved(const QualityReport& /*report*/) override { log += 'i'; }

  std::string& log;
  double longest = std::numeric_limits<double>::infinity();
  int most = 1000;
  bool wants = false;
  std::vector<double> dts;
};

/// The calls that so many frames of length 1 make; the last of them is called so.
std::string calls(const Schedule& schedule, int frames, bool mesh = true) {
  std::string log;
  Told tracker(log, mesh);
  Moves moves(log);
  Driver driver(tracker, moves, schedule);
  for (int i = 1; i <= frames; ++i) {
    driver.frame(i, moves, i == frames ? FrameIs::last : FrameIs::one_of_many);
    log += ' ';
  }
  return log;
}

}  // namespace

TEST_CASE("a frame moves, remodels, improves and ends, and each is told in that order") {
  CHECK(calls({1, 1, 1}, 2) == "am<RrcIicE> am<RrcIicE> ");
  CHECK(calls({1, 0, 1}, 2) == "am<RrcE> am<RrcE> ");
  CHECK(calls({0, 1, 0}, 2) == "am<Iic> am<Iic> ");
  CHECK(calls({0, 0, 0}, 2) == "am am ");
}

TEST_CASE("a schedule counts frames, and what is done at all is done after the last") {
  CHECK(calls({2, 3, 0}, 5) == "am am<Rrc> am<Iic> am<Rrc> am<RrcIic> ");
  CHECK(calls({0, 2, kLastFrame}, 3) == "am am<Iic> am<IicE> ");
  CHECK(calls({0, 0, 2}, 3, false) == "am am<E> am<E> ");
  CHECK(calls({0, 0, kLastFrame}, 3, false) == "am am am<E> ");
}

TEST_CASE("a simulator hears of no change where a surgery was refused or had nothing to do") {
  for (const Outcome outcome : {Outcome::refused, Outcome::unchanged}) {
    std::string log;
    Told tracker(log, true);
    tracker.outcome = outcome;
    Moves moves(log);
    Driver(tracker, moves, {1, 0, 0}).frame(1, moves);
    CHECK(log == "am<Rr>");
  }
}

TEST_CASE("what has vanished is moved on but neither improved nor remodelled again") {
  std::string log;
  Told tracker(log, true);
  tracker.vanishes = true;
  Moves moves(log);
  Driver driver(tracker, moves, {1, 1, 1});
  driver.frame(1, moves);
  driver.frame(2, moves);
  CHECK(log == "am<RrcE>am<E>");
  CHECK(tracker.time() == 2);
}

TEST_CASE("a frame is cut into equal steps no longer than the simulator asks for") {
  std::string log;
  Told tracker(log, true);
  Moves moves(log);
  moves.longest = 0.3;
  Driver(tracker, moves, {1, 1, 1}).frame(1, moves);
  CHECK(log == "amamamam<RrcIicE>");
  CHECK(moves.dts == std::vector<double>(4, 0.25));
  CHECK(tracker.time() == 1);
  moves.most = 3;
  log.clear();
  Driver(tracker, moves, {0, 0, 0}).frame(2, moves);
  CHECK(log == "amamam");
}

TEST_CASE("a mesh is remodelled within a frame where the simulator wants it, never after it") {
  const auto log_of = [](const Schedule& schedule, bool mesh) {
    std::string log;
    Told tracker(log, mesh);
    Moves moves(log);
    moves.longest = 0.5;
    moves.wants = true;
    Driver(tracker, moves, schedule).frame(1, moves);
    return log;
  };
  CHECK(log_of({1, 1, 1}, true) == "am<RrcIicE>am<RrcIicE>");
  CHECK(log_of({0, 2, 2}, true) == "am<IicE>am");
  CHECK(log_of({0, 0, 0}, true) == "amam");
  CHECK(log_of({0, 0, 1}, false) == "amam<E>");
}

TEST_CASE("a schedule that cannot be kept is refused") {
  std::string log;
  Moves moves(log);
  Told mesh(log, true), grid(log, false);
  CHECK_THROWS_AS(Driver(mesh, moves, {-1, 1, 1}), InvalidInput);
  CHECK_THROWS_AS(Driver(mesh, moves, {1, -1, 1}), InvalidInput);
  CHECK_THROWS_AS(Driver(mesh, moves, {1, 1, -1}), InvalidInput);
  CHECK_THROWS_AS(Driver(grid, moves, {1, 0, 1}), InvalidInput);
  CHECK_THROWS_AS(Driver(grid, moves, {0, 1, 1}), InvalidInput);
  CHECK_NOTHROW(Driver(grid, moves, {0, 0, 1}));
}

TEST_CASE("a driver's mesh is, to the last bit, what a bare tracker makes of the same calls") {
  const Triangles start = beside(subdivided_ball(3, 1), subdivided_ball(3, 1), {2.3, 0, 0});
  Keys keys({{"rate", {0.1, "here"}}}, "motion", "here");
  const auto motion = make_motion("mean_curvature", keys, {});
  const auto twin = [] {
    Keys same({{"rate", {0.1, "here"}}}, "motion", "here");
    return make_motion("mean_curvature", same, {});
  }();
  const TrackerOptions options{.cell_size = 0.3};
  const auto mesh = make_mesh_tracker(start, options);
  Tracker plain(start, options);
  Driver driver(*mesh, *motion, {2, 1, kLastFrame});
  StepWatcher nobody;
  for (int i = 1; i <= 4; ++i) {
    driver.frame(0.1 * i, nobody);
    twin->advance(plain, 0.1 * i - plain.time());
    if (i % 2 == 0) plain.remodel();
    plain.improve();
  }
  CHECK(same_bits(mesh->surface(), plain.surface()));
  CHECK(mesh->time() == plain.time());
}

TEST_CASE("a motion that displaces vertices is refused by a level set, which stays as it was") {
  LevelSetOptions options;
  options.cell_size = 0.25;
  const auto grid = make_level_set_tracker(subdivided_ball(3, 1), options);
  Keys keys({}, "motion", "here");
  const auto motion = make_motion("normal_flow", keys, {});
  Driver driver(*grid, *motion, {0, 0, kLastFrame});
  StepWatcher nobody;
  const Triangles before = grid->surface();
  CHECK_THROWS_WITH(driver.frame(0.1, nobody), Catch::Contains("velocity field"));
  CHECK(same_bits(grid->surface(), before));
}
