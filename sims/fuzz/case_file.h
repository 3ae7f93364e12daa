// Cases are kept as TOML files that refer to nothing outside, with every number to the last bit.
#pragma once

#include <filesystem>
#include <string>

#include "sims/fuzz/fuzz_case.h"

namespace suture::sims {

/// A case, and why it is kept.
struct CorpusCase {
  FuzzCase fuzz_case;
  std::string check;  ///< that objected, or once did; empty for a case that is only shown
  std::string cause;  ///< one line
};

/// The case as TOML, its cause in the first line. Numbers are the shortest decimals that give the
/// same double again.
std::string to_toml(const CorpusCase& c);

/// \throw InvalidInput with file, line and what is wrong if it is not what to_toml gives
CorpusCase read_case(const std::filesystem::path& file);

}  // namespace suture::sims
