#!/usr/bin/env bash
# The Snakefile's plan of jobs, without running any. usage: plan.sh SNAKEFILE; 77: no Snakemake here
set -eu
snakefile=$1
command -v snakemake >/dev/null || { echo "snakemake is not installed"; exit 77; }

folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cat >"$folder/settings.json" <<'END'
{"cases": 0, "range": 200, "first_seed": 1, "profiles": ["random", "hostile"], "nice": 0,
 "arithmetics": ["filtered"], "collapses": ["keep"], "range_hours": 1, "mem_mb": 100, "fuzz_options": ""}
END

# plan CASES: the summaries that would be made, one a line.
plan() {
  snakemake --dry-run --snakefile "$snakefile" --directory "$folder" --nolock --cores 1 \
    --configfile "$folder/settings.json" --config "cases=$1" 2>&1 |
    awk '/^ *output: parts/ {print $2}' | sort
}

# Whole ranges of both profiles: 1,000 cases are 3 ranges of 200 for each.
plan 1000 >"$folder/short"
plan 1900 >"$folder/long"
[ "$(wc -l <"$folder/short")" -eq 6 ] || { echo "planned:"; cat "$folder/short"; exit 1; }
[ "$(wc -l <"$folder/long")" -eq 10 ] || { echo "planned:"; cat "$folder/long"; exit 1; }
grep -qx parts/hostile.filtered.keep/0000000401.json "$folder/short"
[ -z "$(comm -23 "$folder/short" "$folder/long")" ]

# What is done is not planned again.
mkdir -p "$folder/parts/hostile.filtered.keep"
touch "$folder/parts/hostile.filtered.keep/0000000401.json"
plan 1000 >"$folder/rest"
[ "$(comm -23 "$folder/short" "$folder/rest")" = parts/hostile.filtered.keep/0000000401.json ]
