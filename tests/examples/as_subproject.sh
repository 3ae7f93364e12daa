#!/usr/bin/env bash
# Configures a parent project that takes Suture in by add_subdirectory. Building it would compile all
# of the library again, so the test reads what would be compiled, and how.
# usage: as_subproject.sh SOURCE WORK CMAKE-ARGUMENT...
set -euo pipefail
here=$(cd "$(dirname "$0")" && pwd)
source=$1 work=$2
shift 2

absent=()  # a machine that lacks what only simulators need, and threads
for package in VTK OpenVDB MPI TBB fmt tomlplusplus; do
  absent+=("-DCMAKE_DISABLE_FIND_PACKAGE_$package=ON")
done
cmake -S "$here/as_subproject" -B "$work" -DSUTURE_SOURCE="$source" -DCMAKE_EXPORT_COMPILE_COMMANDS=ON \
  "${absent[@]}" "$@" --log-level=NOTICE
! grep -q HYPRE "$work/CMakeCache.txt" || { echo "a subproject looks for HYPRE"; exit 1; }
commands=$work/compile_commands.json
own=$(grep -F 'as_subproject/own.cpp' "$commands" | grep command)
[ -n "$own" ] || { echo "the parent's program is not there"; exit 1; }
for flag in -Werror -Wconversion -ffp-contract -fuse-ld; do
  ! grep -qF -e "$flag" <<<"$own" || { echo "the parent's program is compiled with $flag"; exit 1; }
done
grep -qE -e '-std=(c|gnu)\+\+20' <<<"$own" || { echo "C++20 is not passed on"; exit 1; }
grep -qF "$work/suture/include" <<<"$own" || { echo "the public headers are not passed on"; exit 1; }
! grep -qF -e "-I$source " <<<"$own" || { echo "the parent sees headers that are not public"; exit 1; }
! grep '"file"' "$commands" | grep -qF -e "$source/sims/" -e "$source/tests/surgery" ||
  { echo "a subproject builds simulators or tests"; exit 1; }
grep '"command"' "$commands" | grep -F kernel/audit.cpp | grep -qF -e -ffp-contract=off ||
  { echo "the library lost its floating-point flags"; exit 1; }

# Of what is built nothing but the headers, which cost nothing: the parent's include is among them.
cmake --build "$work" --target suture_public_headers >/dev/null
[ -f "$work/suture/include/suture/surgery/tracker.h" ] || { echo "no public headers"; exit 1; }
