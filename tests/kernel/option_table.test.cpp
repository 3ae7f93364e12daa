#include "kernel/option_table.h"

#include <catch2/catch.hpp>

#include "tests/option_checks.h"

using namespace suture;
using Catch::Matchers::Contains;

namespace {

enum class Taste { sweet, sour };
constexpr std::array<Named<Taste>, 2> kTastes = {{{"sweet", Taste::sweet}, {"sour", Taste::sour}}};

struct Inner {
  int count = 3;
};

struct Cake {
  double size = 0;
  double weight = 2.5;
  Point at = Point::UnitX();
  bool round = true;
  std::uint64_t seed = 1;
  Taste taste = Taste::sour;
  std::string maker = "Ann";
  std::string shape = "tall";
  std::vector<double> times{1, 2};
  std::optional<int> layers;
  Inner inner;
};

const OptionTable<Cake>& cakes() {
  static const OptionTable<Cake> table(
      "cake",
      {{"size",
        &Cake::size,
        {.meaning = "edge", .unit = unit::length, .range = Range::above(0), .required = true}},
       {"weight",
        &Cake::weight,
        {.meaning = "mass", .unit = unit::density, .range = Range::at_least(0).or_infinite()}},
       {"at", &Cake::at, {.meaning = "centre", .unit = unit::length}},
       {"round", &Cake::round, {.meaning = "shape"}},
       {"seed", &Cake::seed, {.meaning = "chance", .range = Range::at_least(0)}},
       {"taste", {&Cake::taste, kTastes}, {.meaning = "taste"}},
       {"maker", &Cake::maker, {.meaning = "who made it"}},
       {"shape", {&Cake::shape, {"tall", "flat"}}, {.meaning = "shape"}},
       {"times", &Cake::times, {.meaning = "times", .range = Range::at_least(0)}},
       {"layers", &Cake::layers, {.meaning = "layers", .range = Range::between(1, 9)}},
       {"count", inside(&Cake::inner, &Inner::count), {.meaning = "count"}}});
  return table;
}

Value value_of(const Cake& cake, const std::string& name) {
  return *cakes().row(name).field.get(cake);
}

}  // namespace

TEST_CASE("options of every type keep what they are given and refuse what is out of range") {
  check_table(cakes());
}

TEST_CASE("defaults are those of the struct, and what must be given has none") {
  CHECK(cakes().row("weight").about.usual == Value(2.5));
  CHECK(cakes().row("taste").about.usual == Value(std::string("sour")));
  CHECK(cakes().row("count").about.usual == Value(std::int64_t{3}));
  CHECK_FALSE(cakes().row("size").about.usual);
  CHECK_FALSE(cakes().row("layers").about.usual);
  CHECK(values(Cake{}, cakes()).size() == cakes().rows().size() - 1);
}

TEST_CASE("an integer's range ends where its type does") {
  CHECK(cakes().row("count").about.range.high == std::numeric_limits<int>::max());
  CHECK(cakes().row("seed").about.range.high == std::numeric_limits<double>::infinity());
}

TEST_CASE("a change of the unit of length scales each option by its dimension") {
  Cake cake;
  cake.size = 3;
  scale_lengths(cake, cakes(), 2);
  CHECK(cake.size == 12);
  CHECK(cake.at == Point(4, 0, 0));
  CHECK(cake.weight == 2.5 / 64);
  CHECK(cake.times == std::vector<double>{1, 2});
}

TEST_CASE("a check names the option, its value and what is allowed") {
  Cake cake;
  cake.size = 1;
  check(cake, cakes(), "cake.");
  cake.layers = 10;
  CHECK_THROWS_WITH(check(cake, cakes(), "cake."), "cake.layers is 10; allowed is from 1 to 9");
  cake.layers = {};
  cake.at[1] = std::nan("");
  CHECK_THROWS_WITH(check(cake, cakes(), "cake."), "cake.at is nan; give a finite number");
  cake.at = Point::Zero();
  cake.taste = Taste(7);
  CHECK_THROWS_WITH(check(cake, cakes(), ""), Contains("taste") && Contains("sweet, sour"));
}

TEST_CASE("an option that is not there is refused with the nearest name") {
  Cake cake;
  CHECK_THROWS_WITH(set(cake, cakes(), "weigth", 1.0), Contains("did you mean \"weight\"?"));
  CHECK_THROWS_WITH(set(cake, cakes(), "taste", std::string("sowr")),
                    Contains("cake.taste is \"sowr\"; did you mean \"sour\"?"));
}

TEST_CASE("values in words read back to the same bits") {
  CHECK(in_words(0.1) == "0.1");
  CHECK(in_words(2147483647.0) == "2147483647");
  CHECK(in_words(1e9) == "1000000000");
  CHECK(in_words(1e16) == "1e+16");
  CHECK(in_words(1e-5) == "1e-05");
  CHECK(in_words(0.0001) == "0.0001");
  CHECK(in_words(-0.0) == "-0");
  CHECK(in_words(std::numeric_limits<double>::infinity()) == "inf");
  CHECK(in_words(std::vector<double>{1, 0.5}) == "[1, 0.5]");
  CHECK(in_words(value_of(Cake{}, "round")) == "true");
}
