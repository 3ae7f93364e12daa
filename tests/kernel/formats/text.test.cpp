// Numbers and lines of text.
#include "kernel/formats/text.h"

#include <catch2/catch.hpp>
#include <limits>

#include "tests/kernel/formats/samples.h"

using namespace suture;

TEST_CASE("numbers beyond the doubles become zero where they are small") {
  const TemporaryFolder folder;
  const Triangles s =
      read_text(folder, "a.obj", "v 1e-400 -1e-4000 +1.5\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
  CHECK(s.positions[0] == Point(0, 0, 1.5));
}

TEST_CASE("numbers are read whole or not at all, and written in their shortest form") {
  CHECK(parse_number("1.5").value() == 1.5);
  CHECK(parse_number("+2").value() == 2);
  for (const char* bad : {"", "1.5x", "+-1", "one", "0x10"}) CHECK_FALSE(parse_number(bad));
  CHECK(parse_integer("-9223372036854775808").value() == std::numeric_limits<std::int64_t>::min());
  for (const char* bad : {"", "1.0", "9223372036854775808"}) CHECK_FALSE(parse_integer(bad));
  std::string text;
  append_number(text, 0.1);
  append_number(text += ' ', -0.0);
  append_integer(text += ' ', 18446744073709551615ULL);
  CHECK(text == "0.1 -0 18446744073709551615");
}

TEST_CASE("lines are counted, comments are cut off, and joined lines are one") {
  TextLines text("# top\n\n a b # rest\r\nc \\\n d\nend", "f", {.comment = '#', .continued = true});
  REQUIRE(text.next_line());
  CHECK(text.line() == 3);
  CHECK(text.token() == "a");
  CHECK(text.token() == "b");
  CHECK(text.token().empty());
  CHECK(text.token_anywhere() == "c");
  CHECK(text.token() == "d");
  CHECK(text.line() == 5);
  CHECK(text.rest() == "end");
  CHECK(text.token_anywhere() == "end");
  CHECK(text.token_anywhere().empty());
  CHECK_FALSE(text.next_line());
}
