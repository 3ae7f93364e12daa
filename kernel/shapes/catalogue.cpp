// The shapes by name, for the command line and scenes.
#include "kernel/shapes/catalogue.h"

#include <cmath>
#include <functional>

#include "kernel/errors.h"
#include "kernel/lattice.h"
#include "kernel/shapes/shapes.h"

namespace suture {

namespace {

// Coordinate `axis` of a member that is a point.
template <class P>
struct Coordinate {
  Point P::*member;
  int axis;
};

int whole(const std::string& name, double value) {
  constexpr double kMost = 1e9;  // an int holds it
  if (!(std::abs(value) <= kMost) || value != std::floor(value))
    throw InvalidInput(name + " is " + number(value) +
                       "; it must be a whole number of at most 1000000000");
  return static_cast<int>(value);
}

// One parameter of the struct P: how it is read and written, with what a user is told of it.
template <class P>
struct Binding {
  Binding(double P::*member, std::string name_, std::string unit_, std::string meaning_)
      : name(std::move(name_)),
        unit(std::move(unit_)),
        meaning(std::move(meaning_)),
        read([member](const P& p) { return p.*member; }),
        write([member](P& p, double value) { p.*member = value; }) {}

  Binding(int P::*member, std::string name_, std::string unit_, std::string meaning_)
      : name(std::move(name_)),
        unit(std::move(unit_)),
        meaning(std::move(meaning_)),
        read([member](const P& p) { return static_cast<double>(p.*member); }),
        write([member, n = name](P& p, double value) { p.*member = whole(n, value); }) {}

  Binding(Coordinate<P> c, std::string name_, std::string unit_, std::string meaning_)
      : name(std::move(name_)),
        unit(std::move(unit_)),
        meaning(std::move(meaning_)),
        read([c](const P& p) { return (p.*c.member)[c.axis]; }),
        write([c](P& p, double value) { (p.*c.member)[c.axis] = value; }) {}

  std::string name, unit, meaning;
  std::function<double(const P&)> read;
  std::function<void(P&, double)> write;
};

struct Entry {
  ShapeInfo info;
  std::function<Triangles(const std::map<std::string, double>&)> make;
};

// Every shape also takes its centre and its edge length.
template <class P>
Entry entry(const std::string& name, const std::string& meaning, Triangles (*make)(const P&),
            std::vector<Binding<P>> bindings) {
  bindings.push_back({&P::edge_length, "edge_length", "length", "what the edges are about"});
  for (int a = 0; a < 3; ++a)
    bindings.push_back({Coordinate<P>{&P::centre, a}, kAxisName[a], "length",
                        std::string("where its centre is along ") + kAxisName[a]});
  Entry e{{name, meaning, {}}, {}};
  for (const Binding<P>& b : bindings)
    e.info.parameters.push_back({b.name, b.read(P{}), b.unit, b.meaning});
  e.make = [make, bindings](const std::map<std::string, double>& values) {
    P p;
    for (const Binding<P>& b : bindings)
      if (const auto given = values.find(b.name); given != values.end()) b.write(p, given->second);
    return make(p);
  };
  return e;
}

std::vector<Entry> round_entries() {
  using S = SphereParameters;
  using T = TorusParameters;
  using C = CylinderParameters;
  using D = DumbbellParameters;
  return {
      entry<S>("sphere", "an icosahedron in equal parts, pushed out", sphere,
               {{&S::radius, "radius", "length", "of the sphere"},
                {&S::frequency, "frequency", "whole number",
                 "parts of each icosahedron edge; 0: from edge_length"},
                {&S::exact_volume, "exact_volume", "0 or 1",
                 "1: vertices lie so far outside that the volume is the ball's"}}),
      entry<T>("torus", "a ring round z", torus,
               {{&T::radius, "radius", "length", "to the middle of the tube"},
                {&T::tube_radius, "tube_radius", "length", "of the tube"}}),
      entry<C>("cylinder", "along z, with flat caps", cylinder,
               {{&C::radius, "radius", "length", "of the caps"},
                {&C::height, "height", "length", "between the caps"}}),
      entry<D>("dumbbell", "two balls along z, joined by a neck", dumbbell,
               {{&D::radius, "radius", "length", "of each ball"},
                {&D::distance, "distance", "length", "between the balls' centres"},
                {&D::neck_radius, "neck_radius", "length", "of the neck"},
                {&D::fillet, "fillet", "length", "radius of the round between neck and ball"}})};
}

std::vector<Entry> other_entries() {
  using B = BoxParameters;
  using Z = ZalesakParameters;
  using S = SheetParameters;
  using C = CarvedBallParameters;
  using A = AnimalParameters;
  using H = HandParameters;
  return {
      entry<B>("box", "a box of grids", box,
               {{Coordinate<B>{&B::size, 0}, "size_x", "length", "its extent along x"},
                {Coordinate<B>{&B::size, 1}, "size_y", "length", "its extent along y"},
                {Coordinate<B>{&B::size, 2}, "size_z", "length", "its extent along z"}}),
      entry<Z>("zalesak", "Zalesak's slotted sphere with its sharp edges", zalesak,
               {{&Z::radius, "radius", "length", "of the sphere"},
                {&Z::slot_width, "slot_width", "length", "between the slot's walls, along x"},
                {&Z::slot_top, "slot_top", "length", "the slot's floor over the centre, along y"}}),
      entry<S>("sheet", "a thin plate across z, flat or bent", sheet,
               {{&S::length, "length", "length", "along x, along the bend"},
                {&S::width, "width", "length", "along y"},
                {&S::thickness, "thickness", "length", "across the sheet"},
                {&S::bend, "bend", "degrees", "between its two ends"}}),
      entry<C>("carved_ball", "a ball with deep grooves as ornament", carved_ball,
               {{&C::radius, "radius", "length", "of the ball"},
                {&C::depth, "depth", "radius", "of the grooves"},
                {&C::groove_width, "groove_width", "radius", "of the grooves"},
                {&C::seed, "seed", "whole number", "of the ornament"}}),
      entry<A>("animal", "a four-legged animal with thin legs, y up, x ahead", animal,
               {{&A::length, "length", "length", "scales all of it"},
                {&A::leg_radius, "leg_radius", "body length", "of the lower legs"}}),
      entry<H>("hand", "a hand with its fingers spread along x, the thumb to y", hand,
               {{&H::length, "length", "length", "from wrist to fingertip; scales all of it"},
                {&H::finger_radius, "finger_radius", "hand length", "of the fingers"}})};
}

const std::vector<Entry>& entries() {
  static const std::vector<Entry> all = [] {
    std::vector<Entry> list = round_entries();
    for (Entry& e : other_entries()) list.push_back(std::move(e));
    return list;
  }();
  return all;
}

template <class List>
std::string names(const List& list) {
  std::string text;
  for (const auto& item : list) text += (text.empty() ? "" : ", ") + item.name;
  return text;
}

}  // namespace

const std::vector<ShapeInfo>& shape_catalogue() {
  static const std::vector<ShapeInfo> all = [] {
    std::vector<ShapeInfo> list;
    for (const Entry& e : entries()) list.push_back(e.info);
    return list;
  }();
  return all;
}

Triangles make_shape(const std::string& name, const std::map<std::string, double>& parameters) {
  for (const Entry& e : entries()) {
    if (e.info.name != name) continue;
    for (const auto& [key, value] : parameters) {
      bool known = false;
      for (const ShapeParameter& p : e.info.parameters) known = known || p.name == key;
      if (!known)
        throw InvalidInput("shape \"" + name + "\" has no parameter \"" + key +
                           "\"; it takes: " + names(e.info.parameters));
      if (!std::isfinite(value))
        throw InvalidInput("shape \"" + name + "\": " + key + " must be a finite number");
    }
    return e.make(parameters);
  }
  throw InvalidInput("there is no shape \"" + name + "\"; there are: " + names(shape_catalogue()));
}

}  // namespace suture
