#!/bin/bash
# Runs the paper's cases (cases.csv, in its order) one after the other, each to its own d/B (the column until) or to
# --until where that is less. Cases that got there are skipped and stopped ones resumed, so it can be killed and started
# again at any time, and a case that has only its peak can be taken further.
#   tests/paper/campaign.sh [--screening] [--until D] [--out DIR] [--binary FILE] [--threads N] [CASE PATTERN...]
# Full fidelity goes to DIR/full/CASE, --screening (surrogate everywhere, all to d/B = 0.4) to DIR/screening/CASE.
# Then: tests/paper/collect.py DIR; tests/paper/verdicts.py; sandgraph report DIR/full -o REPORT.
set -u
here=$(cd "$(dirname "$0")" && pwd)
configs=$here/../../configs/paper
binary=$here/../../build/release/sandgraph
out=out/paper limit=1 threads=$(nproc) kind=full patterns=()
while [ $# -gt 0 ]; do
    case $1 in
        --screening) kind=screening ;;
        --until) limit=$2; shift ;;
        --out) out=$2; shift ;;
        --binary) binary=$2; shift ;;
        --threads) threads=$2; shift ;;
        -*) sed -n '2,8p' "$0" >&2; exit 2 ;;
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

# Load rows are 0.0005 apart.
reached() { tail -n 1 "$1/load.csv" | awk -F, -v until="$2" '{ exit !($1 >= until - 0.001) }'; }

run_case() {
    local name=$1 scene=$2 until=$3 folder=$out/$kind/$1 set options=()
    local IFS=';'
    for set in $4 "title=$name"; do options+=(--set "$set"); done
    if [ "$kind" = screening ]; then
        options+=(--mode screening --set gate.active=false)
        until=0.4
    fi
    until=$(awk -v a="$until" -v b="$limit" 'BEGIN { print a < b ? a : b }')
    [ -e "$folder/summary.json" ] && reached "$folder" "$until" && return 0
    if [ -e "$folder/checkpoint.h5" ]; then options+=(--resume); fi
    mkdir -p "$folder"
    echo "$(date +%T) $kind/$name"
    "$binary" run "$configs/$scene.toml" -o "$folder" --threads "$threads" --until "$until" "${options[@]}" \
        >>"$folder/log.txt" 2>&1 </dev/null || echo "$kind/$name: exit code $?"
}

while IFS=, read -r name scene until set; do
    [ "$name" != name ] && wanted "$name" && run_case "$name" "$scene" "$until" "$set"
done <"$here/cases.csv"
