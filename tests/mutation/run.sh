#!/usr/bin/env bash
# The mutation check: tests/mutation/run.sh [--again] [--quick] [--jobs=N] [--no-build] [TEXT...]. Puts all mutants of
# tests/mutation/mutants/ into a copy of the sources (build/mutation/tree), builds its tests once, and runs them for one
# mutant after the other, chosen by SANDGRAPH_MUTANT. Interrupt it at any time: build/mutation/results.csv says which
# are done. --again: those that survived once more, after a new test. --quick: only the first tests of each. TEXT: only
# mutants of that room, or whose name, file or fragment it is.
set -euo pipefail
here=$(dirname "$(readlink -f "${BASH_SOURCE[0]}")")
top=$(readlink -f "$here/../..")
tree=$top/build/mutation/tree
build=yes rest=()
for word in "$@"; do
    if [ "$word" = --no-build ]; then build=no; else rest+=("$word"); fi
done
if [ $build = yes ]; then
    python3 "$here/mutated_tree.py" "$tree"
    (cd "$tree" && cmake --preset release -DCMAKE_DISABLE_FIND_PACKAGE_Torch=ON >/dev/null)
    nice cmake --build "$tree/build/release" --target $(python3 "$here/mutants.py" ${rest[@]+"${rest[@]}"}) --parallel ${JOBS:-2} -- -k 0
fi
exec python3 "$here/run_mutants.py" "$tree" "$top/build/mutation/results.csv" ${rest[@]+"${rest[@]}"}
