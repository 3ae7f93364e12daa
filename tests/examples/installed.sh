#!/usr/bin/env bash
# Installs a finished build into WORK, builds the examples against it, by CMake and one by pkg-config,
# and runs them.
# usage: installed.sh BUILD WORK CMAKE-ARGUMENT...
set -euo pipefail
here=$(cd "$(dirname "$0")" && pwd)
build=$1 work=$2
shift 2

rm -rf "$work/moved" "$work/prefix" "$work/out"
cmake --install "$build" --prefix "$work/prefix" >/dev/null
mv "$work/prefix" "$work/moved"  # the package says nowhere where it was installed
! grep -rlI --include='*.cmake' --include='*.pc' "$work/prefix" "$work/moved" ||
  { echo "the package names the folder that it was installed to"; exit 1; }

# Headers reach one another under suture/, and each is there.
cd "$work/moved/include"
grep -rhoE '#include "[^"]+"' . | sort -u | while read -r _ header; do
  header=${header//\"/}
  [ -f "$header" ] || { echo "installed headers include $header, which is not installed"; exit 1; }
done
[ "$(grep -rl '#include "suture/' . | wc -l)" -gt 10 ] || { echo "few headers were installed"; exit 1; }

cmake -S "$here" -B "$work/build" -DCMAKE_PREFIX_PATH="$work/moved" "$@"
cmake --build "$work/build"
mkdir -p "$work/out"
cd "$work"
for example in two_spheres readme own_velocity read_and_write measure; do
  echo "== $example"
  "build/$example"
done
[ -s out/union.obj ] && [ -s out/moved.ply ]

# By pkg-config: a program, and all headers at once under the strictest flags, but for those of CGAL.
command -v pkg-config >/dev/null || { echo "pkg-config is missing; tests/run installs it"; exit 1; }
PKG_CONFIG_PATH=$(dirname "$(find "$work/moved" -name suture.pc)")
export PKG_CONFIG_PATH
compiler=c++ flags=
for argument; do
  [[ $argument != -DCMAKE_CXX_COMPILER=* ]] || compiler=${argument#*=}
  [[ $argument != -DCMAKE_CXX_FLAGS* ]] || flags+=" ${argument#*=}"
done
read -ra cflags <<<"$flags $(pkg-config --cflags suture)"
read -ra libs <<<"$(pkg-config --libs suture)"
"$compiler" -std=c++20 "${cflags[@]}" "$here/read_and_write.cpp" -o by_pkg_config "${libs[@]}"
./by_pkg_config
(cd "$work/moved/include" && grep -rL CGAL/ suture | sort | sed 's/.*/#include "&"/') >all.cpp
"$compiler" -std=c++20 -Wall -Wextra -Wpedantic -Wshadow -Werror "${cflags[@]}" -fsyntax-only all.cpp
