// Fingerprints of bytes and of surfaces: what has another one is another thing.
#pragma once

#include <string>
#include <string_view>

#include "kernel/triangles.h"

namespace suture::sims {

/// FNV-1a in sixteen hexadecimal digits: tells apart what should be the same, and is no help
/// against those who want a collision.
std::string fingerprint(std::string_view bytes);

/// The fingerprint of the surface's bits, in the order of its vertices and triangles.
std::string fingerprint(const Triangles& surface);

}  // namespace suture::sims
