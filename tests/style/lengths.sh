#!/usr/bin/env bash
# Files of at most 400 lines, functions of at most 60.
source "$(dirname "$0")/common.sh"

check() {
  local awk_file
  awk_file=$(cd "$(dirname "$0")" && pwd)/lengths.awk
  (cd "$1" && sources . kernel predicates surgery sims tests | while read -r file; do
    awk -v most=400 'END { if (NR > most) print FILENAME ":1: " NR " lines; at most " most }' "$file"
    awk -v most=60 -f "$awk_file" "$file"
  done)
}

lines() { seq "$1" | sed 's/.*/  f();  \/\/ } not a brace/'; }

self_test() {
  { echo 'namespace a {'; echo 'struct B {'; echo '  B(int c)'; echo '      : c_{c} {'; lines 57
    echo '  }'; echo '};'; echo 'const char* d = R"(}'; echo '{)";'
    echo 'void g() {'; lines 58; echo '}'; lines 200; echo '}  // namespace a'; } |
    plant kernel/a.cpp
  expect_clean
  { echo 'void g(int a,'; echo '       int b) {'; echo 'if (a) { f("}"); }'; lines 57; echo '}'; } |
    plant kernel/b.cpp
  expect_fault '^kernel/b.cpp:1: a function of 61 lines'
  { echo 'struct B {'; echo '  B(int c)'; echo '      : c_{c} {'; lines 58; echo '  }'; echo '};'; } |
    plant kernel/c.cpp
  expect_fault '^kernel/c.cpp:2: a function of 61 lines'
  { echo 'TEST_CASE("a") {'; lines 60; echo '}'; } | plant tests/d.test.cpp
  expect_fault '^tests/d.test.cpp:1: a function of 62 lines'
  lines 401 | plant sims/e.cpp
  expect_fault '^sims/e.cpp:1: 401 lines'
}

main "$@"
