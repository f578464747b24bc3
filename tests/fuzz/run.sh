#!/usr/bin/env bash
# Fuzzes the readers: tests/fuzz/run.sh EXECUTIONS [READER...]. Build first:
#   cmake --preset fuzz && cmake --build --preset fuzz
# The corpus grows in build/fuzz/corpus/<reader>; a finding is left as build/fuzz/<reader>-crash-*, and after
# mending goes to tests/fuzz/findings/<reader>, where every build tests it.
set -euo pipefail
export LSAN_OPTIONS=print_suppressions=0:suppressions=$(dirname "$(readlink -f "${BASH_SOURCE[0]}")")/lsan.supp
top=$(dirname "$(readlink -f "${BASH_SOURCE[0]}")")/../..
bin=$top/build/fuzz
executions=${1:?how many executions}
shift
[ $# -gt 0 ] || set -- scene element_test recipe probe train segments packing_csv packing_h5 info checkpoint resealed \
    history_h5 model_h5 run_h5
for reader in "$@"; do
    corpus=$bin/corpus/$reader
    mkdir -p "$corpus"
    "$bin/tests/fuzz/fuzz_$reader" --sample "$corpus/sample"
    echo "== $reader"
    # An allocation over 256 MiB, a run over 10 s and a leak are findings, too.
    longest=$(($(stat -c %s "$corpus/sample") * 5 / 4 + 4096))
    "$bin/tests/fuzz/fuzz_$reader" "$corpus" -runs="$executions" -max_len=$longest -timeout=10 -malloc_limit_mb=256 \
        -rss_limit_mb=2048 -artifact_prefix="$bin/$reader-" -print_final_stats=1 2>&1 |
        grep -E "ERROR|SUMMARY|Test unit|stat::(number_of_executed|average_exec|peak_rss)|logic_error" || true
done
