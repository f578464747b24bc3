"""The mutants as data: tests/mutation/mutants/ROOM.toml, and how they are put into a copy of the sources.

A table says where and which tests are to notice, cheapest first:

    folder = "engine/graph"
    tests = ["unit/graph", "determinism"]
    mutants = [
        { in = "screening/gate.cpp", at = "text of one line", old = "part of it", new = "what stands there instead" },
    ]

`at` stands once in the file and may be left out where `old` does, `old` stands once in `at`. `equivalent` says why
nobody can notice. A mutant's name is a hash of these words: it stays when others come and go.
"""
import dataclasses
import pathlib
import sys
import tomllib
import zlib

here = pathlib.Path(__file__).resolve().parent
top = here.parent.parent


@dataclasses.dataclass(frozen=True)
class Mutant:
    room: str
    file: str  # below the top of the source tree
    at: str
    old: str
    new: str
    tests: tuple
    equivalent: str = ""

    @property
    def name(self):
        words = "\n".join((self.file, self.at, self.old, self.new))
        return f"{zlib.crc32(words.encode()):08x}"

    def __str__(self):
        return f"{self.name} {self.file}: {self.old}  ->  {self.new or 'nothing'}"


def read_table(path):
    table = tomllib.loads(path.read_text())
    for row in table["mutants"]:
        yield Mutant(path.stem, f"{table['folder']}/{row['in']}", row.get("at", row["old"]), row["old"], row["new"],
                     tuple(row.get("tests", table["tests"])), row.get("equivalent", ""))


def read_all(folder=here / "mutants"):
    return [mutant for path in sorted(folder.glob("*.toml")) for mutant in read_table(path)]


class TableError(Exception):
    pass


def span(mutant, text):
    """Where the fragment lies in the file's text."""
    for part, whole, what in ((mutant.at, text, "file"), (mutant.old, mutant.at, "line")):
        if whole.count(part) != 1:
            raise TableError(f"{mutant}: '{part}' stands {whole.count(part)} times in the {what}, not once; change "
                             f"tests/mutation/mutants/{mutant.room}.toml with the source")
    if "\n" in mutant.at:
        raise TableError(f"{mutant}: more than one line")
    begin = text.index(mutant.at) + mutant.at.index(mutant.old)
    return begin, begin + len(mutant.old)


def chosen(mutant):
    return f"::sandgraph::mutant(0x{mutant.name}u)"


def switched(old, mutants):
    """The fragment with its mutants, chosen at run time: a statement if it ends as one, else an expression."""
    if old.endswith(";"):
        words = "".join(f"if ({chosen(m)}) {{ {m.new} }} else " for m in mutants)
        return f"{{ {words}{{ {old} }} }}"
    words = "".join(f"{chosen(m)} ? ({m.new}) : " for m in mutants)
    return f"({words}({old}))"


def end_of_declaration(text, begin):
    depth = 0
    for at in range(begin, len(text)):
        depth += {"{": 1, "(": 1, "}": -1, ")": -1}.get(text[at], 0)
        if depth <= 0 and text[at] in ";}":
            return at
    return len(text)


def without_constants(text):
    """What has a mutant in it is no longer known to the compiler."""
    pieces = text.split("constexpr ")
    out, begin = pieces[0], len(pieces[0])
    for piece in pieces[1:]:
        begin += len("constexpr ")
        mutated = "::sandgraph::mutant(" in text[begin:end_of_declaration(text, begin)]
        out += ("const " if mutated else "constexpr ") + piece
        begin += len(piece)
    return out


def with_mutants(text, mutants):
    places = {}
    for mutant in mutants:
        places.setdefault(span(mutant, text), []).append(mutant)
    last = len(text)
    for (begin, end), there in sorted(places.items(), reverse=True):
        if end > last:
            raise TableError(f"{there[0]}: lies across another one's fragment")
        last = begin
        text = text[:begin] + switched(there[0].old, there) + text[end:]
    return '#include "base/mutant.hpp"\n#line 1\n' + without_constants(text)


def by_file(mutants):
    files = {}
    for mutant in mutants:
        files.setdefault(mutant.file, []).append(mutant)
    return files


def named(mutants, texts, quick=False):
    """Those to be run: of any of the rooms, or with any of the texts in name, file or fragment; all without a text.
    `quick`: with the first of their tests alone."""
    mutants = list(mutants)
    rooms = {m.room for m in mutants}
    for m in mutants:
        if not m.equivalent and (not texts or any(t == m.room if t in rooms else t in str(m) for t in texts)):
            yield dataclasses.replace(m, tests=m.tests[:1]) if quick else m


def targets(mutants):
    """The test programs as CMake knows them."""
    return sorted({"test_" + test.split(":")[0].replace("/", "_") for m in mutants for test in m.tests})


if __name__ == "__main__":
    words = sys.argv[1:]
    print(*targets(named(read_all(), [w for w in words if not w.startswith("--")], "--quick" in words)))
