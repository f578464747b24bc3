#!/bin/bash
# Speed against error over gate.strain alone, to d/B 0.1, and a census (every point audited) of each case:
# dense and loose horizontal plates and a vertical one, H/B = 3. Some 40 minutes of one core; stopped runs go on.
#   tests/bench/pareto.sh [BINARY] [DIR] [CASE...]
# Then: build/release/tests/bench_audit_coverage DIR/*/census
set -u
here=$(cd "$(dirname "$0")/../.." && pwd)
binary=${1:-$here/build/release/sandgraph} out=${2:-out/pareto}
shift $(($# > 2 ? 2 : $#))
gate=(--set gate.flow=0 --set gate.spread=1 --set gate.distance=2 --set gate.second_order_work=-10 --set gate.acoustic=-1e3
    --set gate.stress_ratio=3 --set anchor.pull_to=0.1 --set "output.frames=[0,0.01,0.02,0.04,0.06,0.1]")
study() {
    local name=$1 scene=$here/configs/paper/$2.toml
    shift 2
    "$binary" pareto "$scene" -o "$out/$name" --threads 1 --thresholds 0.003,0.01,0.03,0.1,0.3 "${gate[@]}" "$@"
    "$binary" run "$scene" -o "$out/$name/census" --threads 1 --mode screening "${gate[@]}" --set gate.active=false \
        --set audit.share=1 "$@"
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
