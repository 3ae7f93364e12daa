# What the style checks share: where the sources are, and the proof that a check can fail.
# A check is a function `check ROOT` that prints each fault as file:line: what, and nothing else.

set -u

# sources ROOT FLOOR...: its .h and .cpp files, relative to ROOT.
sources() {
  local root=$1 floor
  shift
  (cd "$root" && for floor in "$@"; do
    [ -d "$floor" ] && find "$floor" -name '*.h' -o -name '*.cpp'
  done | LC_ALL=C sort)
}

# plant PATH: a file of the planted project with standard input as its text.
plant() {
  mkdir -p "$planted/$(dirname "$1")"
  cat >"$planted/$1"
}

# expect_clean and expect_fault PATTERN: what the check must say of the planted project.
expect_clean() {
  local found
  found=$(check "$planted")
  [ -z "$found" ] || { echo "self-test: a clean project was refused: $found"; exit 1; }
}
expect_fault() {
  local found
  found=$(check "$planted")
  grep -qE "$1" <<<"$found" || { echo "self-test: not found: $1; found: $found"; exit 1; }
}

# main ROOT: the check, exit 1 on a fault; main --self-test: plants faults and wants each found.
main() {
  if [ "$1" = --self-test ]; then
    planted=$(mktemp -d)
    trap 'rm -rf "$planted"' EXIT
    self_test
  else
    local found
    found=$(check "$1")
    [ -z "$found" ] || { echo "$found"; exit 1; }
    [ "$(sources "$1" kernel predicates surgery sims tests | wc -l)" -gt 0 ] ||
      { echo "no sources under $1"; exit 1; }
  fi
}
