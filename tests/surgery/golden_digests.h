// The digests of golden.test.cpp. Paste here the line that a new case prints.
#pragma once

#include <cstdint>

namespace suture {

struct Golden {
  const char* name;
  std::uint64_t digest;
};

// clang-format off
inline constexpr Golden kGolden[] = {
    {"straighten distance_field rounded", 0xf5ca6f9f41568fb1ULL},
    {"straighten distance_field filtered", 0x310808e7be5bab87ULL},
    {"straighten distance_field rational", 0x310808e7be5bab87ULL},
    {"straighten crossing rounded", 0xfdcd7fcd95c3ff27ULL},
    {"straighten crossing filtered", 0x4ae296aa689a716cULL},
    {"straighten crossing rational", 0x4ae296aa689a716cULL},
    {"keep distance_field rounded", 0xd990d2f10d95f165ULL},
    {"keep distance_field filtered", 0x8403e918fb839767ULL},
    {"keep distance_field rational", 0x8403e918fb839767ULL},
    {"keep crossing rounded", 0xf0695e24ad5fa9fcULL},
    {"keep crossing filtered", 0x17918043de5d28f0ULL},
    {"keep crossing rational", 0x17918043de5d28f0ULL},
    {"paper distance_field rounded", 0x3bde9ecfa9908becULL},
    {"paper distance_field filtered", 0xe4f05f68e0297eadULL},
    {"paper distance_field rational", 0xe4f05f68e0297eadULL},
    {"paper crossing rounded", 0x538d59b673d6dbfaULL},
    {"paper crossing filtered", 0xd945e9b777e89a52ULL},
    {"paper crossing rational", 0xd945e9b777e89a52ULL},
    {"events merge deep", 0x4ae296aa689a716cULL},
    {"events merge plain", 0x9737546afcd5731cULL},
    {"events split deep", 0xc18e2204e83d0f6cULL},
    {"events split plain", 0x9737546afcd5731cULL},
    {"events both deep", 0xff5341d3a1510668ULL},
    {"events both plain", 0x9737546afcd5731cULL},
    {"events none deep", 0x760d2cef6c7d7975ULL},
    {"events none plain", 0x760d2cef6c7d7975ULL},
    {"subdivision midpoint", 0x52091f90d2de1f03ULL},
    {"subdivision fitted", 0xdc4fb1690f5097e7ULL},
    {"edges by curvature", 0x12e9a2edad540848ULL},
    {"subdivision curved", 0x97e8f9cf61339657ULL},
    {"hostile 0", 0x909e265c3b2c7e47ULL},
    {"hostile 1", 0x0e78e6de67ea17a0ULL},
    {"hostile 2", 0x8bef4e9e0dfa603cULL},
    {"hostile 3", 0x07ef1f36e8a3be97ULL},
    {"hostile 4", 0x6a32b3995a35dfe5ULL},
    {"hostile 5", 0xea1a1718c5fd3fe3ULL},
    {"hostile 6", 0x606ae6461ff97848ULL},
    {"hostile 7", 0x236bb13e1d4ad05fULL},
    {"hostile 8", 0x5192943ab21ff1efULL},
    {"hostile 9", 0xb42bccb3cf639da5ULL},
    {"hostile 10", 0x209d6eff01a26e6bULL},
    {"hostile 11", 0xd9c260bb9008c3bbULL},
    {"curl noise", 0xcc8e3039e75a8433ULL},
    {"shape sphere", 0x463bd837f369156dULL},
    {"shape torus", 0x2111132f11f48f81ULL},
    {"shape cylinder", 0xcd48ab437d9f76c9ULL},
    {"shape dumbbell", 0xe111acb9a6233243ULL},
    {"shape box", 0xa53f9eb01dc88405ULL},
    {"shape zalesak", 0xc357809482ed4d12ULL},
    {"shape sheet", 0xe5200301022caccdULL},
    {"shape carved_ball", 0xe66bfe7afeca2ef3ULL},
    {"shape animal", 0xa6ac4e0925d49a60ULL},
    {"shape hand", 0x6378cf8c2755f5e0ULL},
};
// clang-format on

}  // namespace suture
