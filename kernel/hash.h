// Hashes with the same bits on every machine: for tables, draws and digests; none is a secret.
#pragma once

#include <cstdint>
#include <string_view>

namespace suture {

/// 2⁶⁴ divided by the golden ratio, and odd: steps of it fall evenly between those before.
inline constexpr std::uint64_t kGoldenStep = 0x9e3779b97f4a7c15ULL;

/// One-to-one, and each bit of x changes half of the bits: the last step of SplitMix64 [Steele, Lea
/// and Flood 2014; Vigna 2015].
constexpr std::uint64_t spread(std::uint64_t x) {
  x = (x ^ (x >> 30)) * 0xbf58476d1ce4e5b9ULL;
  x = (x ^ (x >> 27)) * 0x94d049bb133111ebULL;
  return x ^ (x >> 31);
}

/// The hash h with the word x mixed in: one multiplication, by a constant of MurmurHash3 [Appleby
/// 2011]. The order of the words counts.
constexpr std::uint64_t mixed(std::uint64_t h, std::uint64_t x) {
  h = (h ^ x) * 0xff51afd7ed558ccdULL;
  return h ^ (h >> 32);
}

/// An FNV-1a hash of 64 bits begins with this number.
inline constexpr std::uint64_t kFnvStart = 0xcbf29ce484222325ULL;

/// FNV-1a [Fowler, Noll and Vo 1991] of the bytes, going on from `hash`.
constexpr std::uint64_t fnv1a(std::string_view bytes, std::uint64_t hash = kFnvStart) {
  for (const char c : bytes) hash = (hash ^ static_cast<unsigned char>(c)) * 0x100000001b3ULL;
  return hash;
}

/// FNV-1a of the word's eight bytes, the lowest first on every machine, going on from `hash`.
constexpr std::uint64_t fnv1a(std::uint64_t word, std::uint64_t hash) {
  for (int byte = 0; byte < 8; ++byte, word >>= 8) hash = (hash ^ (word & 0xff)) * 0x100000001b3ULL;
  return hash;
}

}  // namespace suture
