#!/usr/bin/env python3
"""Every path that a page names must exist: docs_paths.py [ROOT]. Prints what is missing, exits with 1 if there is any.

Looked at: words like engine/mpm/points.hpp or tests/*/README.md anywhere in a page, and the targets of its links, from
the page's own folder. A name in capitals (engine/ROOM/NAME.hpp) stands for any.
"""

import pathlib
import re
import sys

PAGES = ("README.md", "docs/*.md", "*/README.md", "engine/*/README.md", "tests/*/README.md")
PATH = re.compile(r"(?<![\w./-])((?:engine|surrogate|training|configs|docs|tests|cmake)/[\w./*-]*[\w/*])")
LINK = re.compile(r"\]\((?!https?:|#)([^)#]+)(?:#[^)]*)?\)")
PLACEHOLDER = re.compile(r"(?<![A-Z])(?!README|PEERS)[A-Z]{4,}")


def missing(root):
    for page in sorted({page for pattern in PAGES for page in root.glob(pattern)}):
        for number, line in enumerate(page.read_text(encoding="utf-8").splitlines(), 1):
            named = [(root, name) for name in PATH.findall(LINK.sub("", line))]
            named += [(page.parent, name) for name in LINK.findall(line)]
            for base, name in named:
                there = any(base.glob(name.rstrip("/"))) if "*" in name else (base / name).exists()
                if not there and not PLACEHOLDER.search(name):
                    yield f"{page.relative_to(root)}:{number}: no {name}"


def main():
    root = pathlib.Path(sys.argv[1] if len(sys.argv) > 1 else pathlib.Path(__file__).parent.parent).resolve()
    found = list(missing(root))
    print("\n".join(found) if found else "every path named in the pages exists")
    return 1 if found else 0


if __name__ == "__main__":
    sys.exit(main())
