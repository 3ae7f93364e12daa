// Whole files: read at once, and replaced or left as they were.
#include "kernel/files.h"

#include <catch2/catch.hpp>

#include "kernel/errors.h"
#include "tests/kernel/folder.h"

using namespace suture;
using Catch::Matchers::Contains;

TEST_CASE("all bytes that are written are read back") {
  const TemporaryFolder folder;
  std::string bytes("\0\xff\n\r\n", 5);
  for (int doubling = 0; doubling < 16; ++doubling) bytes += bytes;
  write_file(folder / "a", bytes);
  CHECK(read_file(folder / "a") == bytes);
  write_file(folder / "a", "");
  CHECK(read_file(folder / "a").empty());
}

TEST_CASE("a file that cannot be read or written is refused with the system's reason") {
  const TemporaryFolder folder;
  CHECK_THROWS_WITH(read_file(folder / "none"), Contains("there is no such file"));
  CHECK_THROWS_WITH(read_file(folder.path()), Contains("this is a folder"));
  CHECK_THROWS_WITH(write_file(folder / "none" / "a", "x"), Contains("No such file"));
  CHECK_THROWS_WITH(write_file(folder.path(), "x"), Contains("this is a folder"));
}
