// Seeds, dictionaries and findings of the fuzzers, replayed by an ordinary program.
#include <catch2/catch.hpp>

#include <algorithm>
#include <filesystem>
#include <vector>

#include "kernel/files.h"
#include "tests/fuzz/targets.h"
#include "tests/paths.h"

using namespace suture;
using namespace suture::fuzz;

namespace fs = std::filesystem;

namespace {

const fs::path kFolder = fs::path(suture::source_dir()) / "tests/fuzz";

/// The files of a folder in the order of their names; none where there is no folder.
std::vector<fs::path> files(const fs::path& folder) {
  std::vector<fs::path> all;
  if (fs::is_directory(folder))
    for (const auto& entry : fs::directory_iterator(folder)) all.push_back(entry.path());
  std::sort(all.begin(), all.end());
  return all;
}

std::size_t replay(const char* folder) {
  std::size_t count = 0;
  for (const Target& target : kTargets)
    for (const fs::path& file : files(kFolder / folder / target.name)) {
      INFO(file.string());
      CHECK_NOTHROW(target.run(read_file(file)));
      ++count;
    }
  return count;
}

}  // namespace

TEST_CASE("what the fuzzers start from is read soundly or refused") { CHECK(replay("seeds") > 0); }

TEST_CASE("what the fuzzers found does no harm any more") { replay("findings"); }

TEST_CASE("every start of a seed is read soundly or refused") {
  for (const Target& target : kTargets)
    for (const fs::path& file : files(kFolder / "seeds" / target.name)) {
      const std::string bytes = read_file(file);
      INFO(file.string());
      const std::size_t step = std::max<std::size_t>(1, bytes.size() / 16);
      for (std::size_t n = 0; n < bytes.size(); n += step) {
        INFO(n);
        CHECK_NOTHROW(target.run(std::string_view(bytes).substr(0, n)));
      }
    }
}
