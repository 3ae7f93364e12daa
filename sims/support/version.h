// The program's version, as the build names it.
#pragma once

namespace suture::sims {

inline constexpr const char* kVersion = SUTURE_VERSION;

}  // namespace suture::sims
