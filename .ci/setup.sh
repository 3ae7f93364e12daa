# What tests/run and sims/run share: bring what is missing, configure, build. To be sourced.

root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
build=$root/build

packages=(g++ cmake ninja-build ccache mold libcgal-dev libgmp-dev libmpfr-dev libeigen3-dev
  libcli11-dev libtomlplusplus-dev libfmt-dev nlohmann-json3-dev
  libvtk9-dev libegl-dev libglew-dev libpng-dev bzip2 python3 gnuplot-nox
  libopenvdb-dev libboost-dev libboost-iostreams-dev libtbb-dev
  libhypre-dev libopenmpi-dev)
test_packages=(catch2 clang-format pkg-config)
sanitizer_packages=(clang libclang-rt-dev)  # sanitizers and libFuzzer come with the second

fail() {
  echo "$(basename "$0"): $*" >&2
  exit 2
}

# Installs those of the packages that are not there yet; needs no network where all are.
install_missing() {
  local package missing=() as_root=()
  command -v dpkg-query >/dev/null ||
    fail "this is not Debian; install the like of: $*; then build with cmake --preset release"
  for package in "$@"; do
    [ "$(dpkg-query -W -f '${db:Status-Status}' "$package" 2>/dev/null)" = installed ] ||
      missing+=("$package")
  done
  [ ${#missing[@]} -gt 0 ] || return 0
  if [ "$(id -u)" -ne 0 ]; then
    command -v sudo >/dev/null ||
      fail "not root, and there is no sudo; as root run: apt-get install ${missing[*]}"
    as_root=(sudo)
  fi
  echo "installing: ${missing[*]}"
  "${as_root[@]}" apt-get update -q ||
    fail "apt-get update failed; is the network there?"
  "${as_root[@]}" env DEBIAN_FRONTEND=noninteractive \
    apt-get install -q -y --no-install-recommends "${missing[@]}" ||
    fail "apt-get could not install ${missing[*]}"
}

# As many compilers as there are cores, and at most one for each 2 GB of memory: a file that
# includes CGAL takes up to 1.7 GB.
compilers() {
  local cores memory
  cores=$(nproc)
  memory=$(awk '/^MemTotal/ {print int($2 / 2000000)}' /proc/meminfo)
  [ "$memory" -ge 1 ] || memory=1
  echo $((cores < memory ? cores : memory))
}

# Arguments go to cmake. A build folder that is there keeps its generator and its choices.
configure() {
  local generator=(-G Ninja)
  [ ! -f "$build/CMakeCache.txt" ] || generator=()
  cmake -S "$root" -B "$build" "${generator[@]}" "$@" ||
    fail "cmake could not configure $build; if it is an old one, remove it"
}

build_targets() {
  cmake --build "$build" --parallel "$(compilers)" "$@" || fail "the build failed"
}

# The build with sanitizers, by clang++, in build-fuzz. Arguments go to cmake.
configure_fuzzers() {
  build=$root/build-fuzz
  mkdir -p "$build"
  (cd "$root" && cmake --preset fuzz "$@") >"$build/configure.log" 2>&1 ||
    fail "cmake could not configure $build: see $build/configure.log"
}
