#!/usr/bin/env bash
# The stability suite in full: builds it and writes tests/stability/results.md and .csv after every case. Interrupt it
# at any time; `--resume` goes on where it was (all cases that the table holds are left out, of whatever revision).
# `--only TEXT` measures some cases anew and keeps the rest of the table.
set -euo pipefail
top=$(dirname "$(readlink -f "${BASH_SOURCE[0]}")")/../..
cd "$top"
cmake --preset release >/dev/null
cmake --build --preset release --target stability >/dev/null
export SANDGRAPH_CACHE=${SANDGRAPH_CACHE:-$PWD/build/release/stability_cache}
exec build/release/tests/stability/stability -o tests/stability/results "$@"
