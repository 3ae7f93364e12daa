#!/usr/bin/env bash
# Two random draws are never arguments of one call: compilers evaluate those in different orders.
# Braces are fine, since they are evaluated from left to right.
source "$(dirname "$0")/common.sh"

check() {
  (cd "$1" && sources . kernel predicates surgery sims tests | xargs -r -d '\n' awk '
    /\((random_?|dice)\.[a-z_]+\([^()]*\), *(random_?|dice)\.[a-z_]+\(/ {
      print FILENAME ":" FNR ": two draws in one call; use braces, or name them first" }')
}

self_test() {
  plant kernel/a.cpp <<<'  const Point p{random.uniform(-1, 1), random.uniform(-1, 1), 0};'
  plant tests/b.h <<<'  if (random.below(4) == 0) x = nudged(x, random.below(2));'
  expect_clean
  plant kernel/c.cpp <<<'  const Point p = Point(random.uniform(-1, 1), random.uniform(-1, 1), 0);'
  expect_fault '^kernel/c.cpp:1: two draws'
  plant tests/d.h <<<'  f(dice.below(n), dice.below(12));'
  expect_fault '^tests/d.h:1: two draws'
}

main "$@"
