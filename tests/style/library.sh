#!/usr/bin/env bash
# The library never prints, exits, or draws numbers that differ between machines.
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
    }')
}

self_test() {
  plant kernel/a.cpp <<<'  std::snprintf(text, 9, "%d", n);  // never std::cout'
  plant sims/cli/main.cpp <<<'  std::cout << "hello";'
  expect_clean
  plant surgery/b.cpp <<<'  std::cout << "hello";'
  expect_fault '^surgery/b.cpp:1: the library prints'
  plant surgery/c.cpp <<<'  std::printf("hello");'
  expect_fault '^surgery/c.cpp:1: the library prints'
  plant predicates/d.h <<<'  if (bad) exit(1);'
  expect_fault '^predicates/d.h:1: the library ends'
  plant kernel/e.cpp <<<'  std::uniform_real_distribution<double> u;'
  expect_fault '^kernel/e.cpp:1: numbers that differ'
}

main "$@"
