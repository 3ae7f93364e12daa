#!/usr/bin/env bash
# Every source is as clang-format leaves it.
source "$(dirname "$0")/common.sh"

check() {
  command -v clang-format >/dev/null || { echo "clang-format is missing; tests/run installs it"; return; }
  (cd "$1" && sources . kernel predicates surgery sims tests |
    xargs -r -d '\n' clang-format --dry-run -Werror --style=file 2>&1 | grep -E 'error:')
}

self_test() {
  cp "$(dirname "$0")/../../.clang-format" "$planted/"
  plant kernel/a.h <<<'int f(int x);'
  expect_clean
  plant tests/kernel/b.test.cpp <<<'int  f( int x );'
  expect_fault '^tests/kernel/b.test.cpp:1:'
}

main "$@"
