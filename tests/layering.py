#!/usr/bin/env python3
"""Checks the architecture by machine: layering.py [ROOT]. Prints every breach, exits with 1 if there is one.

Rules: #include arrows between the folders of engine/ follow ARROWS, which has no circle; only graph/ names
tbb::flow; engine/ never includes libtorch; sources are in known folders of the top level only; no source file is over
MAX_LINES.
"""

import pathlib
import re
import sys

MAX_LINES = 400

# folder: folders it may include from, itself apart
ARROWS = {
    "base": set(),
    "dem": {"base"},
    "mpm": {"base"},
    "stress": {"base"},
    "graph": {"base", "dem", "mpm", "stress"},
    "scene": {"base", "dem", "graph"},  # its structs are the engine's settings
    "io": {"base", "dem", "stress"},
    "packings": {"base", "dem", "stress", "graph", "scene", "io"},
    "laboratory": {"base", "dem", "stress", "graph", "scene", "io", "packings"},
    "simulation": {"base", "dem", "mpm", "stress", "graph", "scene", "io", "packings", "surrogate"},
    "results": {"base", "mpm", "graph", "scene", "io", "packings", "simulation", "surrogate"},
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
TASK_GRAPH = re.compile(r"tbb::flow|tbb/flow_graph")


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


def check_size(relative, text):
    lines = text.count("\n")
    if lines > MAX_LINES:
        yield f"{relative}: {lines} lines, more than {MAX_LINES}; are there two rooms in it?"


def circle(arrows):
    """A circle in the table as a list of folders, or None."""

    def visit(folder, path):
        if folder in path:
            return path[path.index(folder):] + [folder]
        return next(filter(None, (visit(target, path + [folder]) for target in sorted(arrows[folder]))), None)

    return next(filter(None, (visit(folder, []) for folder in arrows)), None)


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
    for path in sources(root):
        relative, text = path.relative_to(root), path.read_text(encoding="utf-8")
        for check in (check_includes, check_task_graph, check_size):
            yield from check(relative, text)


def size_report(root, count=5):
    sizes = sorted(((p.read_text(encoding="utf-8").count("\n"), str(p.relative_to(root))) for p in sources(root)))
    total = sum(lines for lines, _ in sizes)
    longest = ", ".join(f"{name} {lines}" for lines, name in reversed(sizes[-count:]))
    return f"{len(sizes)} files, {total} lines; longest: {longest}"


def main():
    root = pathlib.Path(sys.argv[1] if len(sys.argv) > 1 else pathlib.Path(__file__).parent.parent).resolve()
    found = list(breaches(root))
    for breach in found:
        print(breach)
    print(size_report(root))
    return 1 if found else 0


if __name__ == "__main__":
    sys.exit(main())
