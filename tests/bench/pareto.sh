#!/bin/bash
# Speed against error along the path a user goes, gate.strain and gate.flow with all else as it is, to d/B 0.2, and a census
# (the surrogate everywhere, every point audited, to 0.1): dense and loose horizontal plates and a vertical one, H/B = 3.
# Some 50 minutes of one core; stopped runs go on. One thread: what counts is processor time (cpu_ratio).
#   tests/bench/pareto.sh [BINARY] [DIR] [CASE...]
# Then: build/release/tests/bench_audit_coverage DIR/*/census
set -u
here=$(cd "$(dirname "$0")/../.." && pwd)
binary=${1:-$here/build/release/sandgraph} out=${2:-out/pareto}
shift $(($# > 2 ? 2 : $#))
study() {
    local name=$1 scene=$here/configs/paper/$2.toml
    shift 2
    "$binary" pareto "$scene" -o "$out/$name" --threads 1 --set anchor.pull_to=0.2 "$@"
    "$binary" run "$scene" -o "$out/$name/census" --threads 1 --mode screening --set gate.active=false \
        --set audit.share=1 --set anchor.pull_to=0.1 "$@"
}
for case in "${@:-h-dense-3 v-dense-3 h-loose-3}"; do
    for name in $case; do
        case $name in
            h-dense-3) study "$name" horizontal --set anchor.embedment_ratio=3 --set "domain.depth=8 m" ;;
            v-dense-3) study "$name" vertical --set anchor.embedment_ratio=3 --set "domain.depth=6 m" ;;
            h-loose-3) study "$name" horizontal --set anchor.embedment_ratio=3 --set "domain.depth=8 m" \
                --set grains.density=loose ;;
        esac
    done
done
