#!/usr/bin/env bash
# The fuzz campaign: tests/fuzz/run.sh [--runs N] [--no-build] [READER...] builds the fuzzers (preset `fuzz`, clang),
# gives each reader N executions in all (default 1,000,000) and writes the table tests/fuzz/results.md. What was
# executed before counts: interrupt it at any time, it goes on where it was; build/fuzz/executed holds the account.
# The corpus grows in build/fuzz/corpus/READER. A finding is left as build/fuzz/READER-*; after mending it goes to
# tests/fuzz/findings/READER, where every build tests it.
set -euo pipefail
here=$(dirname "$(readlink -f "${BASH_SOURCE[0]}")")
top=$(readlink -f "$here/../..")
bin=$top/build/fuzz
all=(scene element_test recipe probe train segments packing_csv packing_h5 info checkpoint resealed state history_h5
     model_h5 run_h5)
# Bounds of one input: 256 MiB in one allocation, 2 GiB in all, 10 s. Leaks are sought when a part of the campaign ends:
# after every input it would take nine tenths of the time.
bounds=(-malloc_limit_mb=256 -rss_limit_mb=2048 -timeout=10 -detect_leaks=0)
part=50000 # executions of one process
wanted=1000000
most_findings=20
interrupted=72 # libFuzzer's exit code; what was executed till then counts

build=yes readers=()
while [ $# -gt 0 ]; do
    case $1 in
        --runs) wanted=$2; shift ;;
        --no-build) build=no ;;
        *) readers+=("$1") ;;
    esac
    shift
done
[ ${#readers[@]} -gt 0 ] || readers=("${all[@]}")
# Short call stacks and a small quarantine: thrice as many executions; a finding is looked at again without them.
export ASAN_OPTIONS=malloc_context_size=1:quarantine_size_mb=1
export LSAN_OPTIONS=print_suppressions=0:suppressions=$here/lsan.supp
[ $build = no ] || (cd "$top" && cmake --preset fuzz >/dev/null && cmake --build --preset fuzz)
mkdir -p "$bin/executed"

# Column $2 of the account of reader $1, summed.
sum() { awk -F, -v c="$2" '{ s += $c } END { print s + 0 }' "$bin/executed/$1" 2>/dev/null || echo 0; }

# In a fresh build folder the table is the account: what it counts was executed, though its corpus is gone.
recall() {
    [ -e "$bin/executed/$1" ] ||
        awk -F'|' -v reader=" $1 " '$2 == reader && $4 > 0 { print $3 + 0 "," $3 / $4 "," $6 + 0 }' \
            "$here/results.md" >"$bin/executed/$1"
    [ -s "$bin/executed/$1" ] || rm -f "$bin/executed/$1"
    mkdir -p "$bin/corpus/$1"
}

number() { sed -n "s/^stat::$2: *//p" "$1" | tail -1; }

# True for an input that took too long by the clock, on a busy or stopped machine, and does not when read again.
only_waited() {
    local input
    input=$(sed -n 's/.*Test unit written to \(.*-timeout-.*\)/\1/p' "$2")
    [ -n "$input" ] && "$bin/tests/fuzz/fuzz_$1" "${bounds[@]}" "$input" >/dev/null 2>&1 && rm "$input"
}

# One process of the campaign: adds `executions,processor seconds,findings` to the account.
run_part() {
    local reader=$1 runs=$2 corpus=$bin/corpus/$1 log=$bin/executed/$1.log found=0 seconds TIMEFORMAT="%U %S"
    "$bin/tests/fuzz/fuzz_$reader" --sample "$corpus/sample"
    local longest=$(($(stat -c %s "$corpus/sample") * 5 / 4 + 4096)) seeds=("$corpus")
    [ ! -d "$here/findings/$reader" ] || seeds+=("$here/findings/$reader")
    local status=0
    { time "$bin/tests/fuzz/fuzz_$reader" "${seeds[@]}" -runs="$runs" -max_len=$longest "${bounds[@]}" \
        -artifact_prefix="$bin/$reader-" -print_final_stats=1 >"$log" 2>&1; } 2>"$log.time" || status=$?
    [ $status = 0 ] || [ $status = $interrupted ] || found=1
    if [ $found = 1 ] && only_waited "$reader" "$log"; then found=0; fi
    seconds=$(awk '{ print $1 + $2 }' "$log.time")
    echo "$(number "$log" number_of_executed_units),$seconds,$found" >>"$bin/executed/$reader"
    [ $found = 0 ] || grep -E "ERROR|SUMMARY|Test unit|what\(\)" "$log" || true
}

table() {
    echo "# Fuzzing of the readers"
    echo
    echo "Written by \`tests/fuzz/run.sh\`: clang's libFuzzer with AddressSanitizer and UBSan. Bounds of one input:"
    echo "256 MiB in one allocation, 2 GiB in all, 10 s. Findings: parts of the campaign that ended with one, mended or not;"
    echo "what was mended stands in \`tests/fuzz/findings\` and is read by every build (\`ctest -R fuzz:\`)."
    echo "Inputs kept: in the corpus of the build folder at hand; executions of earlier ones are counted, too."
    echo "Memory that grew to 2 GiB over tens of thousands of HDF5 files, though no single file did, was in HDF5's free"
    echo "lists (H5garbage_collect gives it back, no identifier stays open); the target bounds them now."
    echo
    echo "| reader | executions | a second of one core | inputs kept | findings |"
    echo "|---|---|---|---|---|"
    local reader
    for reader in "${all[@]}"; do
        [ -e "$bin/executed/$reader" ] || continue
        awk -F, -v reader="$reader" -v kept="$(find "$bin/corpus/$reader" -type f | wc -l)" \
            '{ n += $1; s += $2; found += $3 }
             END { printf "| %s | %d | %.0f | %d | %d |\n", reader, n, n / s, kept, found }' \
            "$bin/executed/$reader"
    done
}

for reader in "${all[@]}"; do recall "$reader"; done
stop=no
trap 'stop=yes' INT TERM # after the part under way
for reader in "${readers[@]}"; do
    while left=$((wanted - $(sum "$reader" 1))); [ "$left" -gt 0 ]; do
        run_part "$reader" $((left < part ? left : part))
        [ "$(sum "$reader" 3)" -lt $most_findings ] || break
        [ $stop = no ] || break 2
    done
    echo "$reader: $(sum "$reader" 1) executions, $(sum "$reader" 3) findings"
done
table >"$here/results.md"
