#!/usr/bin/env python3
"""Code and theory cite each other: equations.py [ROOT]. Prints what does not fit, exits with 1 if anything.

docs/how_it_works.md numbers its equations, "(7)" or "(7a)" at the start of a line of a block or of a table's cell. Code
cites them in comments, "(eq. 7)", "(eqs. 17 to 19)", "(eqs. 36 and 37)". Every equation cited must be there, every one
there must be cited by some file, and a file that cites must name the page.
"""

import pathlib
import re
import sys

PAGE = "docs/how_it_works.md"
ROOMS = ("engine", "surrogate", "training")
FENCED = re.compile(r"^```[^\n]*\n(.*?)^```$", re.MULTILINE | re.DOTALL)
ROW = re.compile(r"^\|.*\| \((\d+[a-z]?)\) ", re.MULTILINE)
LINE = re.compile(r"^\((\d+[a-z]?)\) ", re.MULTILINE)
CITED = re.compile(r"\(eqs?\. (\d+[a-z]?)(?:\s+(to|and)\s+(\d+[a-z]?))?\)")


def numbered(text):
    found = LINE.findall("\n".join(FENCED.findall(text))) + ROW.findall(text)
    return sorted(found, key=lambda n: (int(re.match(r"\d+", n)[0]), n))


def range_of(first, last, numbers):
    if first in numbers and last in numbers:
        return numbers[numbers.index(first) : numbers.index(last) + 1]
    return [first, last]


def cited(text, numbers):
    unwrapped = re.sub(r"\n\s*// ?", " ", text)
    for first, how, last in CITED.findall(unwrapped):
        yield from range_of(first, last, numbers) if how == "to" else filter(None, (first, last))


def faults(page, sources):
    """Of the page's text and the sources' texts by name."""
    numbers = numbered(page)
    yield from (f"{PAGE}: ({n}) stands twice" for n in sorted(set(numbers)) if numbers.count(n) > 1)
    seen = set()
    for name, text in sources.items():
        here = list(cited(text, numbers))
        seen.update(here)
        yield from (f"{name}: no equation ({n}) in {PAGE}" for n in here if n not in numbers)
        if here and PAGE not in text:
            yield f"{name}: cites equations, but does not name {PAGE}"
    yield from (f"{PAGE}: no code cites ({n})" for n in numbers if n not in seen)


def main():
    root = pathlib.Path(sys.argv[1] if len(sys.argv) > 1 else pathlib.Path(__file__).parent.parent).resolve()
    files = sorted(p for room in ROOMS for p in (root / room).rglob("*.[ch]pp"))
    found = list(faults((root / PAGE).read_text(), {str(p.relative_to(root)): p.read_text() for p in files}))
    print("\n".join(found) if found else "every equation is cited, and none that is not there")
    return 1 if found else 0


if __name__ == "__main__":
    sys.exit(main())
