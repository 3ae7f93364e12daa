// Numbers in binary files, of either byte order, whatever the machine's own is.
#pragma once

#include <algorithm>
#include <bit>
#include <cstring>
#include <string>

namespace suture {

/// The number whose bytes are at `at` in the given order. \pre sizeof(T) bytes are there
template <class T>
T load(const char* at, std::endian order) {
  char bytes[sizeof(T)];
  std::memcpy(bytes, at, sizeof(T));
  if (order != std::endian::native) std::reverse(bytes, bytes + sizeof(T));
  T x;
  std::memcpy(&x, bytes, sizeof(T));
  return x;
}

/// Appends the bytes of x, the lowest first.
template <class T>
void append_little_endian(std::string& bytes, T x) {
  char raw[sizeof(T)];
  std::memcpy(raw, &x, sizeof(T));
  if (std::endian::native != std::endian::little) std::reverse(raw, raw + sizeof(T));
  bytes.append(raw, sizeof(T));
}

}  // namespace suture
