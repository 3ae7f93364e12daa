#!/usr/bin/env bash
# The first line of a source is a comment that says its one idea. Tests say theirs in their names.
source "$(dirname "$0")/common.sh"

check() {
  (cd "$1" && sources . kernel predicates surgery sims tests | grep -v '\.test\.cpp$' |
    xargs -r -d '\n' awk 'FNR == 1 && !/^\/\/ [^ ].......*/ {
      print FILENAME ":1: the first line must be a comment that says what the file is about" }')
}

self_test() {
  plant kernel/a.h <<<'// What a is about.'
  plant tests/a.test.cpp <<<'#include "kernel/a.h"'
  expect_clean
  plant sims/b.cpp <<<'#include "kernel/a.h"'
  expect_fault '^sims/b.cpp:1:'
  plant sims/c.cpp <<<'//'
  expect_fault '^sims/c.cpp:1:'
}

main "$@"
