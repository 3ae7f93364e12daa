// The search is greedy: whatever is smaller and still fails is taken, from the coarsest cuts to the
// finest, until a whole round gains nothing.
#include "sims/fuzz/minimise.h"

#include <algorithm>
#include <cmath>

#include "kernel/measure/measures.h"
#include "kernel/trace.h"
#include "sims/fuzz/named_options.h"
#include "sims/fuzz/smaller.h"

namespace suture::sims {

namespace {

class Minimiser {
 public:
  Minimiser(FuzzCase c, const Trials& trials, const MinimiseLimits& limits)
      : best_{std::move(c), 0}, trials_(trials), limits_(limits) {}

  Minimised go() {
    for (gained_ = true; gained_ && !over();) {
      gained_ = false;
      start_later();
      fewer_operations();
      fewer_components();
      simpler_components();
      fewer_edges();
      simpler_options();
      rounder_positions();
      rounder_values();
    }
    return std::move(best_);
  }

 private:
  bool over() {
    seconds_ += watch_.lap();
    return best_.trials >= limits_.trials || seconds_ > limits_.seconds;
  }

  bool try_case(FuzzCase c) {
    if (over()) return false;
    ++best_.trials;
    if (!trials_.still_fails(c)) return false;
    best_.fuzz_case = std::move(c);
    return gained_ = true;
  }

  bool try_surface(Triangles surface) {
    FuzzCase c = best_.fuzz_case;
    c.surface = std::move(surface);
    return !c.surface.triangles.empty() && try_case(std::move(c));
  }

  /// The surface that an operation is given becomes the case's, and earlier operations go.
  void start_later() {
    for (std::size_t i = best_.fuzz_case.operations.size(); i-- > 1;) {
      FuzzCase c = best_.fuzz_case;
      c.surface = trials_.surface_before(c, i);
      if (c.surface.triangles.empty()) continue;
      c.operations.erase(c.operations.begin(),
                         c.operations.begin() + static_cast<std::ptrdiff_t>(i));
      if (try_case(std::move(c))) return;
    }
  }

  void fewer_operations() {
    for (std::size_t i = best_.fuzz_case.operations.size(); i-- > 0;) {
      FuzzCase c = best_.fuzz_case;
      c.operations.erase(c.operations.begin() + static_cast<std::ptrdiff_t>(i));
      try_case(std::move(c));
    }
  }

  void fewer_components() {
    for (std::uint32_t k = 0; k < components(best_.fuzz_case.surface).count && !over();)
      if (!try_surface(without_component(best_.fuzz_case.surface, k))) ++k;
  }

  void simpler_components() {
    for (std::uint32_t k = 0; k < components(best_.fuzz_case.surface).count && !over(); ++k)
      for (const Stand stand : {Stand::tetrahedron, Stand::box})
        if (try_surface(component_replaced(best_.fuzz_case.surface, k, stand))) break;
  }

  /// Many edges at once first, then fewer, then one by one.
  void fewer_edges() {
    for (std::size_t chunk = best_.fuzz_case.surface.triangles.size() / 4; chunk >= 1 && !over();
         chunk /= 2)
      for (std::size_t at = 0; at < 3 * best_.fuzz_case.surface.triangles.size() && !over();) {
        Triangles fewer = best_.fuzz_case.surface;
        std::size_t done = 0;
        std::size_t corner = at;
        for (; corner < 3 * fewer.triangles.size() && done < chunk; ++corner)
          done += collapse_edge(fewer, corner / 3, corner % 3) ? 1 : 0;
        if (done == 0 || !try_surface(std::move(fewer))) at = std::max(corner, at + 1);
      }
  }

  bool try_options(const TrackerOptions& options) {
    if (named_values(options) == named_values(best_.fuzz_case.options)) return false;
    FuzzCase c = best_.fuzz_case;
    c.options = options;
    return try_case(std::move(c));
  }

  bool try_option(const std::string& name, const Value& value) {
    TrackerOptions options = best_.fuzz_case.options;
    set_option(options, name, value);
    return try_options(options);
  }

  /// All of quality's defaults at once, then every option's own, then rounder cells.
  void simpler_options() {
    TrackerOptions options = best_.fuzz_case.options;
    options.quality = QualityOptions{};
    try_options(options);
    for (const std::string& name : option_names())
      if (const auto& usual = option_named(name).usual) try_option(name, *usual);
    try_option("tracker.collapse", "keep");  // does least
    for (const int bits : {1, 4})
      try_option("tracker.cell_size", rounded_to_bits(best_.fuzz_case.options.cell_size, bits));
  }

  void rounder_positions() {
    for (const int bits : {1, 2, 4, 6, 8, 12, 16, 24, 32, 40, 48})
      if (try_rounded(bits, 0, best_.fuzz_case.surface.positions.size())) break;
    for (const int bits : {2, 8, 24})
      for (std::size_t v = 0; v < best_.fuzz_case.surface.positions.size() && !over(); ++v)
        try_rounded(bits, v, v + 1);
  }

  bool try_rounded(int bits, std::size_t from, std::size_t to) {
    Triangles surface = best_.fuzz_case.surface;
    for (std::size_t v = from; v < to; ++v)
      for (int a = 0; a < 3; ++a)
        surface.positions[v][a] = rounded_to_bits(surface.positions[v][a], bits);
    return surface != best_.fuzz_case.surface && try_surface(std::move(surface));
  }

  void rounder_values() {
    for (std::size_t i = 0; i < best_.fuzz_case.operations.size(); ++i)
      for (const auto& [key, value] : std::map(best_.fuzz_case.operations[i].values))
        for (const int bits : {1, 4, 12}) {
          FuzzCase c = best_.fuzz_case;
          if (auto* x = std::get_if<double>(&c.operations[i].values[key]))
            *x = rounded_to_bits(*x, bits);
          if (c.operations != best_.fuzz_case.operations && try_case(std::move(c))) break;
        }
  }

  Minimised best_;
  const Trials& trials_;
  const MinimiseLimits& limits_;
  Stopwatch watch_;
  double seconds_ = 0;
  bool gained_ = false;
};

}  // namespace

Minimised minimise(FuzzCase c, const Trials& trials, const MinimiseLimits& limits) {
  return Minimiser(std::move(c), trials, limits).go();
}

}  // namespace suture::sims
