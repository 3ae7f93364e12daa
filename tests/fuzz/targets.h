// What the fuzzer runs: for each target, what must hold of any bytes at all.
#pragma once

#include <span>
#include <stdexcept>
#include <string_view>

namespace suture::fuzz {

/// A promise that some bytes broke. Anything else thrown, but InvalidInput within, is one too.
class Finding : public std::logic_error {
 public:
  using std::logic_error::logic_error;
};

/// \throw Finding unless the mesh reader refuses the bytes by InvalidInput, or accepts a sound mesh
/// that its writer gives back with the same bits and that audit and repair can take.
void read_obj(std::string_view bytes);
void read_off(std::string_view bytes);
void read_ply(std::string_view bytes);  ///< text and binary
void read_stl(std::string_view bytes);  ///< text and binary

/// \throw Finding unless the scene is refused by InvalidInput or is one that can be run
void read_scene_text(std::string_view bytes);

/// Makes nearly degenerate points of the bytes. \throw Finding unless the filtered oracle gives the
/// signs of the rational one, and positions are the nearest doubles
void compare_predicates(std::string_view bytes);

struct Target {
  const char* name;
  void (*run)(std::string_view);
};
inline constexpr Target kReaders[] = {
    {"obj", read_obj}, {"off", read_off}, {"ply", read_ply}, {"stl", read_stl}};
inline constexpr Target kTargets[] = {
    {"obj", read_obj}, {"off", read_off},          {"ply", read_ply},
    {"stl", read_stl}, {"scene", read_scene_text}, {"predicates", compare_predicates}};

}  // namespace suture::fuzz
