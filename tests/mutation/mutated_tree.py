"""mutated_tree.py FOLDER: a copy of the sources with all mutants in it, built like any checkout. Only what changed is
written, so that a build goes on where it was."""
import pathlib
import shutil
import sys

import mutants

parts = ["engine", "surrogate", "training", "tests", "cmake", "configs", "CMakeLists.txt", "CMakePresets.json"]

header = """#pragma once
// Of mutated copies only: the mutant that SANDGRAPH_MUTANT names, 0 without one.
namespace sandgraph {
extern unsigned chosen_mutant;
inline bool mutant(unsigned name) { return chosen_mutant == name; }
}  // namespace sandgraph
"""
# Before any other object with a constructor: mutated constants are initialised at the start, too.
source = """#include "base/mutant.hpp"

#include <cstdlib>
namespace sandgraph {
unsigned chosen_mutant = 0;
namespace {
__attribute__((constructor(101))) void choose() {
    if (const char* name = std::getenv("SANDGRAPH_MUTANT"))
        chosen_mutant = static_cast<unsigned>(std::strtoul(name, nullptr, 16));
}
}  // namespace
}  // namespace sandgraph
"""


def files():
    for part in parts:
        path = mutants.top / part
        for file in [path] if path.is_file() else sorted(p for p in path.rglob("*") if p.is_file()):
            if "__pycache__" not in file.parts:
                yield str(file.relative_to(mutants.top)), file


def write(path, content):
    if path.exists() and path.read_bytes() == content:
        return
    path.parent.mkdir(parents=True, exist_ok=True)
    path.write_bytes(content)


def main(folder):
    tree, there = pathlib.Path(folder), mutants.by_file(m for m in mutants.read_all() if not m.equivalent)
    wanted = {"engine/base/mutant.hpp", "engine/base/mutant.cpp"}
    for name, file in files():
        content = file.read_bytes()
        if name in there:
            content = mutants.with_mutants(content.decode(), there[name]).encode()
        write(tree / name, content)
        shutil.copymode(file, tree / name)
        wanted.add(name)
    write(tree / "engine/base/mutant.hpp", header.encode())
    write(tree / "engine/base/mutant.cpp", source.encode())
    for old in tree.rglob("*"):
        name = str(old.relative_to(tree))
        if old.is_file() and not name.startswith("build/") and name not in wanted:
            old.unlink()


if __name__ == "__main__":
    try:
        main(sys.argv[1])
    except mutants.TableError as error:
        sys.exit(f"error: {error}")
