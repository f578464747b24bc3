#!/usr/bin/env bash
# The exact book: runs the scenes of configs/exact and prints case, friction angle, cells a width, points a cell, the
# exact limit factor, ours, and the error. tests/verification/run.sh [-o FOLDER] [CASE...]; a row that is there already
# is not run again. PHI, CELLS [m] and POINTS may be set to fewer values; all of them take about an hour on two cores.
set -euo pipefail
top=$(readlink -f "$(dirname "$(readlink -f "${BASH_SOURCE[0]}")")/../..")
sandgraph=${SANDGRAPH:-$top/build/release/sandgraph}
out=$top/build/verification
if [ "${1:-}" = -o ]; then out=$2; shift 2; fi
[ $# -gt 0 ] || set -- anchor trapdoor footing footing_surcharge wall_passive wall_active anchor_vertical
mkdir -p "$out"

limit() { # CASE PHI CELL POINTS: runs it, if it has not been
    local folder="$out/$1-$2-$3-$4"
    [ -e "$folder/summary.json" ] && return
    rm -rf "$folder"
    "$sandgraph" run "$top/configs/exact/$1.toml" -o "$folder" --set "continuum.friction_angle=$2 deg" \
        --set "continuum.dilation_angle=$2 deg" --set "domain.cell=$3 m" --set "domain.points_per_cell=$4" \
        >"$folder.log" 2>&1 || true
}

row() { # of a summary, or why there is none
    python3 - "$@" <<'PY'
import json, pathlib, sys
case, phi, cell, points, folder = sys.argv[1:]
head = f"{case:18s} {phi:>4s} {1 / float(cell):6.0f} {points:>6s}"
try:
    s = json.loads(pathlib.Path(folder, "summary.json").read_text())
    shown = [("-" if s[k] is None else f"{s[k]:.4g}") for k in ("exact_factor", "limit_factor")]
    error = "-" if s["limit_error"] is None else f"{100 * s['limit_error']:+.1f} %"
    print(f"{head} {shown[0]:>9s} {shown[1]:>9s} {error:>9s}")
except OSError:
    print(f"{head}   {pathlib.Path(folder + '.log').read_text().strip().splitlines()[-1][:90]}")
PY
}

printf '%-18s %4s %6s %6s %9s %9s %9s\n' case phi B/h points exact ours error
for case in "$@"; do
    for phi in ${PHI:-20 30 40}; do
        for points in ${POINTS:-1 4}; do
            for cell in ${CELLS:-0.2 0.1 0.05}; do
                limit "$case" "$phi" "$cell" "$points"
                row "$case" "$phi" "$cell" "$points" "$out/$case-$phi-$cell-$points"
            done
        done
    done
done
