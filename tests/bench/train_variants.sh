#!/bin/bash
# Laws trained on the shipped recipe's data (configs/models/train.toml) with something changed, and measured on the same held-out
# packings; no model is written. Each variant is one command on a recipe that this script writes:
#   tests/bench/train_variants.sh traits [BINARY] [DIR]   # what a law owes to knowing its packing (40 epochs, not 150)
#   tests/bench/train_variants.sh data [BINARY] [DIR]     # error against the number of training histories
# The probes (9 minutes) are made once. Results: DIR/*.errors.csv, gathered in DIR/STUDY.csv.
set -eu
here=$(cd "$(dirname "$0")/../.." && pwd)
study=$1 binary=${2:-$here/build/release/sandgraph} out=${3:-out/train}
mkdir -p "$out"
[ -e "$out/probes.h5" ] || "$binary" rve probe "$here/configs/models/probe.toml" -o "$out/probes.h5"

variant() { # NAME SED-SCRIPT
    [ -e "$out/$1.errors.csv" ] && return
    sed -e 's|^probe .*|logs = "probes.h5"|' -e "$2" "$here/configs/models/train.toml" >"$out/$1.toml"
    "$binary" train "$out/$1.toml" --measure -o "$out/$1.h5" 2>"$out/$1.log"
}

gather() { # the laws' errors, without the twins' that every file repeats
    for file in "$@"; do
        awk -F, -v name="$(basename "$file" .errors.csv)" 'FNR == 1 { next }
            $1 ~ /^(elastic|fitted|learned|mlp|gru)$/ { print name "," $0 }' "$file"
    done | sed '1i variant,of,data,regime,samples,p50,p95,worst,p_bias,q_bias' >"$out/$study.csv"
}

case $study in
    traits)
        for traits in all stiffness none; do
            variant "traits-$traits" "/^rung/a traits = \"$traits\"
                s/^epochs .*/epochs = 40/"
        done
        gather "$out"/traits-*.errors.csv ;;
    data)
        # Small batches, and small rates for the baselines: they need many steps. 0: all, 990.
        while read -r rung histories epochs batch rate; do
            variant "data-$rung-$histories" "s/^rung .*/rung = \"$rung\"/; s/^strain_max/histories = $histories\n&/
                s/^epochs .*/epochs = $epochs/; s/^batch .*/batch = $batch/; s/^rate .*/rate = $rate/"
        done <<'END'
learned 36 100 16 2e-2
learned 150 25 16 2e-2
mlp 36 25 16 3e-3
mlp 150 25 16 3e-3
mlp 0 8 32 3e-3
gru 0 3 32 5e-3
END
        gather "$out"/data-*.errors.csv ;;
esac
