#include "sims/tracking/simulator.h"

#include <catch2/catch.hpp>
#include <fstream>
#include <sstream>

#include "kernel/measure/measures.h"
#include "sims/driver/driver.h"
#include "sims/tracking/mesh_tracker.h"
#include "tests/paths.h"
#include "tests/sims/balls.h"

using namespace suture;
using namespace suture::sims;

namespace {

// --- README.md of sims/tracking shows these lines
class FreeFall : public Simulator {
 public:
  void step(SurfaceTracker& surface, double dt) override {
    const Point middle = velocity_ + 0.5 * dt * kGravity;
    surface.advect([&](const Point&, double) { return middle; }, dt);
    velocity_ += dt * kGravity;
  }
  double longest_step() const override { return 0.05; }

 private:
  const Point kGravity{0, 0, -9.81};
  Point velocity_ = Point::Zero();
};
// ---

std::string contents_of(const std::string& path) {
  std::ifstream in(std::string(source_dir()) + path);
  std::stringstream all;
  all << in.rdbuf();
  return all.str();
}

/// The text between the first `from` and the `to` after it.
std::string between(const std::string& text, const std::string& from, const std::string& to) {
  const std::size_t start = text.find(from) + from.size();
  return text.substr(start, text.find(to, start) - start);
}

}  // namespace

TEST_CASE("the page on simulators shows the example that this test compiles, word for word") {
  const std::string page = contents_of("/sims/tracking/README.md");
  const std::string shown = between(page, "```cpp\n", "```");
  const std::string own = between(contents_of("/tests/sims/tracking/simulator.test.cpp"),
                                  "shows these lines\n", "// ---");
  CHECK(own.size() > 300);
  CHECK(shown == own);
}

TEST_CASE("a simulator of a dozen lines lets a ball fall as Galileo says") {
  const auto mesh = make_mesh_tracker(subdivided_ball(3, 1), {.cell_size = 0.3});
  FreeFall fall;
  Driver driver(*mesh, fall, {1, 1, kLastFrame});
  StepWatcher nobody;
  for (int i = 1; i <= 5; ++i) driver.frame(0.2 * i, nobody);
  const Box box = bounding_box(mesh->surface().positions);
  CHECK((box.low + box.high)[2] / 2 == Approx(-9.81 / 2).margin(0.02));
  CHECK(mesh->time() == Approx(1));
}

TEST_CASE("a time is cut into as few equal steps as are no longer than a simulator's longest") {
  const FreeFall fall;
  CHECK(fall.steps_in(0.049) == 1);
  CHECK(fall.steps_in(0.05) == 1);
  CHECK(fall.steps_in(0.2) == 4);  // rounding does not make it five
  CHECK(fall.steps_in(0.21) == 5);
  CHECK(fall.steps_in(1e9) == fall.most_steps());
}
