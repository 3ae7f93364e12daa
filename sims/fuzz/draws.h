// The draws of a case, each by its name, so that one name more changes no other draw.
#pragma once

#include <array>
#include <string>
#include <string_view>
#include <vector>

#include "kernel/random.h"
#include "kernel/triangles.h"
#include "sims/support/keys.h"

namespace suture::sims {

/// Everything that a seed decides. Each draw follows from a hash of the seed and the draw's name,
/// never from the draws before it. Whoever asks for a name twice is given the same number twice.
class Draws {
 public:
  explicit Draws(std::uint64_t seed) : key_(spread(seed + kGoldenStep)) {}

  /// The draws of a part of the case, with names of its own: `in("body", 2)` is the third body.
  Draws in(std::string_view part, std::uint64_t index = 0) const;

  /// A stream of numbers for one purpose, such as one for each vertex.
  Random of(std::string_view name) const;

  double uniform(std::string_view name, double low, double high) const;
  int whole(std::string_view name, int low, int high) const;  ///< low … high, both included
  bool once_in(std::string_view name, std::uint64_t cases) const;
  Point vector(std::string_view name, double reach) const;  ///< −reach … reach on each axis

  /// One of the words, each as likely, or twice as likely if it stands there twice. The word with
  /// the greatest hash wins [rendezvous hashing, Thaler and Ravishankar 1998]: a new word only
  /// takes draws over, and the order of the words does not matter. \pre there is a word
  std::string choice(std::string_view name, const std::vector<std::string>& words) const;

  /// The value of one of the words, chosen likewise.
  template <class T, std::size_t N>
  T choice(std::string_view name, const std::array<Named<T>, N>& words) const {
    std::vector<std::string> names;
    for (const Named<T>& word : words) names.emplace_back(word.name);
    const std::string chosen = choice(name, names);
    for (const Named<T>& word : words)
      if (chosen == word.name) return word.value;
    return words[0].value;
  }

 private:
  std::uint64_t key_;
};

}  // namespace suture::sims
