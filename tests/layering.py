#!/usr/bin/env python3
"""Checks the architecture by machine: layering.py [ROOT]. Prints every breach, exits with 1 if there is one.

Rules: #include arrows between the folders of engine/ follow ARROWS, which has no circle; nor is there one of modules (a
header and the source of its name); only graph/ names tbb::flow, only mpi/ MPI; engine/ never includes libtorch and prints in app/ and
base/console.cpp only; sources are in known folders of the top level only; no source file is over MAX_LINES, and functions
are as short as FUNCTION_* say.
"""

import pathlib
import re
import sys

from cpp_functions import blanked, functions

MAX_LINES = 400
FUNCTION_MEDIAN = 8  # lines; half of engine/'s functions are shorter,
FUNCTION_P90 = 20  # nine of ten are shorter than this,
FUNCTION_MAX = 40  # and none anywhere is longer

# folder: folders it may include from, itself apart
ARROWS = {
    "base": set(),
    "dem": {"base"},
    "mpm": {"base"},
    "stress": {"base"},
    "graph": {"base", "dem", "mpm", "stress"},
    "scene": {"base", "dem", "mpm", "stress", "graph"},  # its structs are the engine's settings
    "io": {"base", "dem", "stress"},
    "packings": {"base", "dem", "stress", "graph", "scene", "io"},
    "laboratory": {"base", "dem", "stress", "graph", "scene", "io", "packings"},
    "simulation": {"base", "dem", "mpm", "stress", "graph", "scene", "io", "packings", "surrogate"},
    "ranks": {"base", "dem", "graph", "scene", "io", "packings", "simulation"},
    "mpi": {"base", "ranks", "app"},
    "results": {"base", "mpm", "stress", "graph", "scene", "io", "packings", "simulation", "surrogate"},
    "report": {"base", "dem", "mpm", "scene", "io", "laboratory", "results"},
    "app": {"base", "dem", "stress", "graph", "scene", "io", "packings", "laboratory", "simulation", "results",
            "report", "surrogate"},
    # beside engine/
    "surrogate": {"base", "stress", "io"},
    "training": {"base", "dem", "stress", "io", "scene", "surrogate"},
}
TOP_LEVEL = {"engine", "surrogate", "training", "configs", "tests", "cmake", "docs"}
SOURCES = {".cpp", ".hpp", ".py", ".cmake"}
INCLUDE = re.compile(r'^\s*#\s*include\s*([<"])([^>"]+)[>"]', re.MULTILINE)
TORCH = re.compile(r"^(torch|ATen|c10|caffe2)/")
MPI = re.compile(r"\bMPI_[A-Z]\w*|^\s*#\s*include\s*<mpi\.h>", re.MULTILINE)
TASK_GRAPH = re.compile(r"tbb::flow|tbb/flow_graph")
PRINT = re.compile(r"\bfmt::print(?:ln)?\s*\(|\bstd::(?:cout|cerr|clog|puts)\b|(?<![\w.>])(?:std::)?f?printf\s*\(")
CPP = {".cpp", ".hpp"}
PRODUCTION = ("engine", "surrogate", "training")


def sources(root):
    for top in sorted(TOP_LEVEL):
        for path in sorted((root / top).rglob("*")):
            if path.suffix in SOURCES and path.is_file():
                yield path


def folder_of(relative):
    """The layer a file belongs to: engine/dem/x.hpp -> dem; tests and configs have none."""
    parts = relative.parts
    if parts[0] == "engine" and len(parts) > 2:
        return parts[1]
    return parts[0] if parts[0] in ("surrogate", "training") else None


def line_of(text, position):
    return text.count("\n", 0, position) + 1


def check_includes(relative, text):
    folder = folder_of(relative)
    if folder is None:
        return
    if folder not in ARROWS:
        yield f"{relative}: engine/{folder} is no folder of the architecture"
        return
    for match in INCLUDE.finditer(text):
        quote, name = match.groups()
        where = f"{relative}:{line_of(text, match.start())}"
        target = name.split("/")[0]
        if relative.parts[0] == "engine" and TORCH.match(name):
            yield f"{where}: engine/ must not include libtorch ({name})"
        if quote == '"' and target in ARROWS and target != folder and target not in ARROWS[folder]:
            yield f"{where}: {folder} must not include {name}"


def check_task_graph(relative, text):
    if relative.parts[0] == "tests" or folder_of(relative) == "graph":
        return
    for match in TASK_GRAPH.finditer(text):
        yield f"{relative}:{line_of(text, match.start())}: only graph/ may name {match.group()}"


def check_mpi(relative, text):
    if relative.suffix not in CPP or folder_of(relative) == "mpi":
        return
    for match in MPI.finditer(text):
        yield f"{relative}:{line_of(text, match.start())}: only engine/mpi may name {match.group()}"


def check_prints(relative, text):
    if relative.parts[0] != "engine" or folder_of(relative) == "app" or relative.as_posix() == "engine/base/console.cpp":
        return
    code = blanked(text)
    for match in PRINT.finditer(code):
        yield (f"{relative}:{line_of(code, match.start())}: only app/ and base/console.cpp print; use tell() or notice() "
               "of base/console.hpp")


def check_size(relative, text):
    lines = text.count("\n")
    if lines > MAX_LINES:
        yield f"{relative}: {lines} lines, more than {MAX_LINES}; are there two rooms in it?"


def circle(arrows):
    """A circle of the graph {node: nodes that it points at} as a list of nodes, or None."""
    finished, path = set(), []

    def visit(node):
        if node in path:
            return path[path.index(node):] + [node]
        if node in finished:
            return None
        path.append(node)
        found = next(filter(None, map(visit, sorted(arrows.get(node, ())))), None)
        path.pop()
        finished.add(node)
        return found

    return next(filter(None, map(visit, sorted(arrows))), None)


def module_of(path):
    """engine/dem/rve.hpp and rve.cpp -> engine/dem/rve; what a kernel keeps in rve-inl.hpp belongs to it too."""
    return path.with_suffix("").as_posix().removesuffix("-inl")


def module_arrows(files):
    """{module: modules whose headers its header or source includes} of {relative path: text}."""
    arrows = {}
    for path, text in files.items():
        own = module_of(path)
        targets = arrows.setdefault(own, set())
        for quote, name in INCLUDE.findall(text):
            target = next((root / name for root in (pathlib.Path("engine"), pathlib.Path(), path.parent)
                           if root / name in files), None)
            if quote == '"' and target and module_of(target) != own:
                targets.add(module_of(target))
    return arrows


def check_modules(files):
    found = circle(module_arrows(files))
    if found:
        yield "circle of modules: " + " -> ".join(found)


def share_below(lengths, share):
    """The length that `share` of the functions do not pass."""
    return sorted(lengths)[min(len(lengths) - 1, int(share * len(lengths)))]


def check_functions(files):
    lengths = []
    for path, text in files.items():
        for name, line, length in functions(text):
            if length > FUNCTION_MAX:
                yield f"{path}:{line}: {name} has {length} lines, more than {FUNCTION_MAX}"
            if path.parts[0] == "engine":
                lengths.append(length)
    for what, share, limit in (("median", 0.5, FUNCTION_MEDIAN), ("90th percentile", 0.9, FUNCTION_P90)):
        if lengths and share_below(lengths, share) >= limit:
            yield (f"engine/: the {what} of function lengths is {share_below(lengths, share)} lines, to be below "
                   f"{limit}")


def check_top_level(root):
    known = TOP_LEVEL | {"build", "out"}
    for path in sorted(root.iterdir()):
        if not path.is_dir() or path.name.startswith(".") or path.name in known:
            continue
        if any(inner.suffix in SOURCES for inner in path.rglob("*")):  # others hold results of runs
            yield f"{path.name}/: no folder of the architecture"


def breaches(root):
    found = circle(ARROWS)
    if found:
        yield "circle in the table of arrows: " + " -> ".join(found)
    yield from check_top_level(root)
    files = {path.relative_to(root): path.read_text(encoding="utf-8") for path in sources(root)}
    for relative, text in files.items():
        for check in (check_includes, check_task_graph, check_mpi, check_prints, check_size):
            yield from check(relative, text)
    production = {path: text for path, text in files.items() if path.parts[0] in PRODUCTION and path.suffix in CPP}
    yield from check_modules(production)
    yield from check_functions(production)


def size_report(root, count=5):
    files = {str(path.relative_to(root)): path.read_text(encoding="utf-8") for path in sources(root)}
    sizes = sorted((text.count("\n"), name) for name, text in files.items())
    longest = ", ".join(f"{name} {lines}" for lines, name in reversed(sizes[-count:]))
    lengths = [length for name, text in files.items() if name.startswith("engine/") and name.endswith((".cpp", ".hpp"))
               for _, _, length in functions(text)]
    shares = f"median {share_below(lengths, 0.5)}, p90 {share_below(lengths, 0.9)}, longest {max(lengths)}" if lengths else ""
    return (f"{len(sizes)} files, {sum(lines for lines, _ in sizes)} lines; longest: {longest}\n"
            f"{len(lengths)} functions in engine/, lines: {shares}")


def main():
    root = pathlib.Path(sys.argv[1] if len(sys.argv) > 1 else pathlib.Path(__file__).parent.parent).resolve()
    found = list(breaches(root))
    for breach in found:
        print(breach)
    print(size_report(root))
    return 1 if found else 0


if __name__ == "__main__":
    sys.exit(main())
