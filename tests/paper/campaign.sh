#!/bin/bash
# Runs the paper's cases (cases.csv, in its order) one after the other. Finished cases are skipped and stopped ones
# resumed, so it can be killed and started again at any time.
#   tests/paper/campaign.sh [--screening] [--out DIR] [--binary FILE] [--threads N] [CASE PATTERN...]
# Full fidelity goes to DIR/full/CASE, --screening (surrogate everywhere, all to d/B = 0.4) to DIR/screening/CASE.
# Then: tests/paper/verdicts.py --runs DIR; sandgraph report DIR/full -o REPORT.
set -u
here=$(cd "$(dirname "$0")" && pwd)
configs=$here/../../configs/paper
binary=$here/../../build/release/sandgraph
out=out/paper threads=$(nproc) kind=full patterns=()
while [ $# -gt 0 ]; do
    case $1 in
        --screening) kind=screening ;;
        --out) out=$2; shift ;;
        --binary) binary=$2; shift ;;
        --threads) threads=$2; shift ;;
        -*) sed -n '2,6p' "$0" >&2; exit 2 ;;
        *) patterns+=("$1") ;;
    esac
    shift
done

wanted() {
    [ ${#patterns[@]} -eq 0 ] && return 0
    for pattern in "${patterns[@]}"; do
        # shellcheck disable=SC2053
        [[ $1 == $pattern ]] && return 0
    done
    return 1
}

run_case() {
    local name=$1 scene=$2 until=$3 folder=$out/$kind/$1 set options=()
    [ -e "$folder/summary.json" ] && return 0
    local IFS=';'
    for set in $4 "title=$name"; do options+=(--set "$set"); done
    if [ "$kind" = screening ]; then
        options+=(--mode screening --set gate.active=false)
        until=0.4
    fi
    if [ -e "$folder/checkpoint.h5" ]; then options+=(--resume); fi
    mkdir -p "$folder"
    echo "$(date +%T) $kind/$name"
    "$binary" run "$configs/$scene.toml" -o "$folder" --threads "$threads" --until "$until" "${options[@]}" \
        >>"$folder/log.txt" 2>&1 </dev/null || echo "$(date +%T) $kind/$name: exit code $?"
}

while IFS=, read -r name scene until set; do
    [ "$name" != name ] && wanted "$name" && run_case "$name" "$scene" "$until" "$set"
done <"$here/cases.csv"
