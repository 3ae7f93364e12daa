#!/usr/bin/env bash
# Every fault that papers/proof plants still fits the sources: a patch that no longer applies would test nothing.
source "$(dirname "$0")/common.sh"

check() {
  (cd "$1" && for fault in papers/proof/mutations/*.patch; do
    [ -e "$fault" ] || { echo "papers/proof/mutations:1: there are no faults"; break; }
    git apply --check "$fault" >/dev/null 2>&1 ||
      echo "$fault:1: does not apply; make the same fault in the sources as they are now"
  done)
}

self_test() {
  git -C "$planted" init -q
  plant kernel/a.cpp <<<'// What a is about.'
  plant papers/proof/mutations/1.patch <<'PATCH'
what: another word

--- a/kernel/a.cpp
+++ b/kernel/a.cpp
@@ -1 +1 @@
-// What a is about.
+// What b is about.
PATCH
  expect_clean
  plant kernel/a.cpp <<<'// What c is about.'
  expect_fault '^papers/proof/mutations/1.patch:1: does not apply'
}

main "$@"
