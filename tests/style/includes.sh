#!/usr/bin/env bash
# Includes only point down: kernel <- predicates <- surgery <- sims; CGAL stays out of sims.
source "$(dirname "$0")/common.sh"

# Headers that bring CGAL in, directly or through another of ours: one a line.
cgal_headers() {
  local known='<CGAL/' found='' now
  while :; do
    now=$(cd "$1" && sources . kernel predicates surgery | grep '\.h$' |
      xargs -r -d '\n' grep -lE "^ *# *include *($known)" | LC_ALL=C sort)
    [ "$now" != "$found" ] || break
    found=$now
    known="<CGAL/$(sed 's/[.]/\\./g; s/^/|"/; s/$/"/' <<<"$found" | tr -d '\n')"
  done
  echo "$found"
}

check() {
  local cgal
  cgal=$(cgal_headers "$1" | tr '\n' ' ')
  (cd "$1" && sources . kernel predicates surgery sims tests | xargs -r -d '\n' awk -v cgal="$cgal" '
    BEGIN {
      rank["kernel"] = 1; rank["predicates"] = 2; rank["surgery"] = 3; rank["sims"] = 4
      rank["tests"] = 5
      n = split(cgal, list, " ")
      for (i = 1; i <= n; ++i) brings_cgal[list[i]] = 1
    }
    function fault(what) { print FILENAME ":" FNR ": " what }
    /^ *# *include/ {
      split(FILENAME, own, "/")
      if (own[1] == "sims" && $0 ~ /<CGAL\//) fault("sims includes CGAL")
      if (own[1] == "sims" && own[2] != "output" && $0 ~ /<vtk/)
        fault("VTK belongs to sims/output")
      if (!match($0, /"[^"]+"/)) next
      path = substr($0, RSTART + 1, RLENGTH - 2)
      split(path, to, "/")
      if (!(to[1] in rank)) { fault("\"" path "\" does not start with a floor"); next }
      if (rank[to[1]] > rank[own[1]]) fault(own[1] " includes " path ", a floor above it")
      if (own[1] != "sims") next
      if (to[1] == "predicates") fault("sims includes " path "; it sees surgery and kernel only")
      if (to[1] == "surgery" && path !~ /^surgery\/(tracker|options|report|surgery_check)\.h$/)
        fault("sims includes " path "; of surgery it sees tracker.h, options.h, report.h and surgery_check.h")
      if (path in brings_cgal) fault("sims includes " path ", which brings CGAL in")
      if (to[2] == "cli" && own[2] != "cli") fault("only sims/cli includes " path)
    }')
}

self_test() {
  plant kernel/mesh.h <<<'#include <CGAL/Surface_mesh.h>'
  plant kernel/through.h <<<'#include "kernel/mesh.h"'
  plant kernel/plain.h <<<'#include <vector>'
  plant surgery/tracker.h <<<'#include "kernel/plain.h"'
  plant surgery/check/surgery_check.h <<<'#include "kernel/plain.h"'
  plant surgery/operate/cut.h <<<'#include "kernel/through.h"'
  plant sims/driver/run.cpp <<<'#include "surgery/tracker.h"'
  plant sims/fuzz/oracles.cpp <<<'#include "surgery/check/surgery_check.h"'
  plant sims/cli/flags.cpp <<<'#include "sims/driver/run.h"'
  plant tests/surgery/cut.test.cpp <<<'#include "surgery/operate/cut.h"'
  expect_clean
  plant predicates/up.h <<<'#include "surgery/tracker.h"'
  expect_fault '^predicates/up.h:1: predicates includes'
  plant sims/a.cpp <<<'#include "surgery/operate/cut.h"'
  expect_fault '^sims/a.cpp:1: .*of surgery'
  plant sims/b.cpp <<<'#include <CGAL/Surface_mesh.h>'
  expect_fault '^sims/b.cpp:1: sims includes CGAL'
  plant sims/c.cpp <<<'#include "kernel/through.h"'
  expect_fault '^sims/c.cpp:1: .*brings CGAL in'
  plant sims/d.cpp <<<'#include "sims/cli/flags.h"'
  expect_fault '^sims/d.cpp:1: only sims/cli'
  plant sims/e.cpp <<<'#include <vtkActor.h>'
  expect_fault '^sims/e.cpp:1: VTK'
  plant sims/f.cpp <<<'#include "predicates/oracle.h"'
  expect_fault '^sims/f.cpp:1: .*surgery and kernel only'
  plant kernel/g.cpp <<<'#include "g.h"'
  expect_fault '^kernel/g.cpp:1: .*does not start with a floor'
}

main "$@"
