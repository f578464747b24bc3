#!/usr/bin/env bash
# Time per DEM step beside YADE's for the same packing and motion, taken in turn on one core: medians of ROUNDS.
# Needs the Debian package `yade` (not a dependency of the product). Usage: yade_ratio.sh [PACKING.csv] [ROUNDS]
set -euo pipefail
top=$(cd "$(dirname "${BASH_SOURCE[0]}")/../.." && pwd)
packing=${1:-$top/tests/data/yade/packing_dense_p32.csv}
rounds=${2:-5}
binary=$top/build/release/sandgraph

figure() { grep -o 'us_per_step [0-9.]*' | cut -d' ' -f2; }
median() { sort -g | awk '{ v[NR] = $1 } END { print v[int((NR + 1) / 2)] }'; }

tmp=$(mktemp -d)
for _ in $(seq "$rounds"); do
    yade -n -x -j1 "$top/tests/bench/yade_step.py" "$packing" 5000 2>/dev/null | figure >>"$tmp/yade"
    "$binary" rve bench --packing "$packing" --steps 100000 --kernel mixed | figure >>"$tmp/mixed"
    "$binary" rve bench --packing "$packing" --steps 100000 --kernel double | figure >>"$tmp/fast"
    "$binary" rve bench --packing "$packing" --steps 20000 --reference | figure >>"$tmp/reference"
done
yade=$(median <"$tmp/yade") mixed=$(median <"$tmp/mixed") fast=$(median <"$tmp/fast") reference=$(median <"$tmp/reference")
rm -r "$tmp"
awk -v y="$yade" -v m="$mixed" -v f="$fast" -v r="$reference" 'BEGIN {
    printf "YADE %.1f us a step\nmixed kernel %.2f us a step, %.0f times faster\n", y, m, y / m
    printf "double kernel %.2f us a step, %.0f times faster\nreference mode %.2f us a step, %.0f times faster\n", f, y / f, r, y / r }'
