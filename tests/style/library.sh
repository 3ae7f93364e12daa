#!/usr/bin/env bash
# The library never prints, exits, draws numbers that differ between machines, or names a program's
# flags in its messages; and surgery writes no files.
source "$(dirname "$0")/common.sh"

check() {
  (cd "$1" && sources . kernel predicates surgery | xargs -r -d '\n' awk '
    function fault(what) { print FILENAME ":" FNR ": " what }
    {
      sub(/\/\/.*/, "")
      if (/std::(cout|cerr|clog)/ || /<iostream>/ || /(^|[^a-z_])(printf|puts|fprintf) *\(/ ||
          /std::(puts|printf|fprintf) *\(/)
        fault("the library prints; return it in a report, or tell a Trace")
      if (/(^|[^a-z_])(exit|abort|quick_exit|_exit|terminate) *\(/)
        fault("the library ends the program; throw instead")
      if (/(^|[^a-z_])s?rand *\(/ || /random_device/ || /std::[a-z_]+_distribution/)
        fault("numbers that differ between machines; use kernel/random.h")
      if (/"[^"]*--[a-z]/)
        fault("a message names a flag; say what to do in words, and let the program name its flag")
      if (FILENAME ~ /^surgery/ && (/<fstream>/ || /"kernel\/(files|formats\/[a-z_]+)\.h"/))
        fault("surgery reads or writes files; its caller does")
    }')
}

self_test() {
  plant kernel/a.cpp <<<'  std::snprintf(text, 9, "%d", n);  // never std::cout'
  plant sims/cli/main.cpp <<<'  std::cout << "hello; --repair mends that";'
  plant kernel/formats/mesh_io.cpp <<<'#include "kernel/files.h"'
  expect_clean
  plant surgery/b.cpp <<<'  std::cout << "hello";'
  expect_fault '^surgery/b.cpp:1: the library prints'
  plant surgery/c.cpp <<<'  std::printf("hello");'
  expect_fault '^surgery/c.cpp:1: the library prints'
  plant predicates/d.h <<<'  if (bad) exit(1);'
  expect_fault '^predicates/d.h:1: the library ends'
  plant kernel/e.cpp <<<'  std::uniform_real_distribution<double> u;'
  expect_fault '^kernel/e.cpp:1: numbers that differ'
  plant kernel/f.cpp <<<'  throw InvalidInput("open; --repair mends that");'
  expect_fault '^kernel/f.cpp:1: a message names a flag'
  plant surgery/g.cpp <<<'#include "kernel/formats/mesh_io.h"'
  expect_fault '^surgery/g.cpp:1: surgery reads or writes files'
}

main "$@"
