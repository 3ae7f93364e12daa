// Fingerprints of bytes and of surfaces: what has another one is another thing.
#include "sims/support/fingerprint.h"

#include <fmt/format.h>

#include "kernel/hash.h"

namespace suture::sims {

std::string fingerprint(std::string_view bytes) { return fmt::format("{:016x}", fnv1a(bytes)); }

std::string fingerprint(const Triangles& surface) {
  const auto bytes = [](const auto& list) {
    return std::string_view(reinterpret_cast<const char*>(list.data()),
                            list.size() * sizeof(list[0]));
  };
  return fingerprint(fingerprint(bytes(surface.positions)) + fingerprint(bytes(surface.triangles)));
}

}  // namespace suture::sims
