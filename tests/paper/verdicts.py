#!/usr/bin/env python3
"""The paper's statements, one by one, beside what our runs say.

    tests/paper/verdicts.py            prints the table from the stored results
    tests/paper/verdicts.py --write    and stores it as results/table.csv
    tests/paper/verdicts.py --check    is results/table.csv what the stored results give?
    tests/paper/verdicts.py --markdown
    tests/paper/verdicts.py --screening   peak, and load at the same d/B, of every case run both ways
    tests/paper/verdicts.py --cost        wall and processor time of every stored run, and of all together

statements.json holds for each statement what the paper says, an expression over the results (stored.py), and how near
is near enough. Where the paper's words leave a definition open, `others` has further ones, judged the same way, so that
a verdict does not hinge on the choice. To recompute a row from nothing: campaign.sh with the cases in its column
`cases`, then collect.py.
"""
import argparse
import csv
import json
import pathlib
import sys

from accounts import cost_table, screening_table
from stored import NotRun, Results

HERE = pathlib.Path(__file__).parent
ALLOWED = {"__builtins__": {"abs": abs, "min": min, "max": max}}  # in expressions
COLUMNS = ["id", "figure", "statement", "paper", "measured", "verdict", "other definitions", "source", "cases", "explanation"]


def judged(statement, value):
    """Measured as text, and the verdict."""
    if isinstance(value, bool):
        return "yes" if value else "no", "holds" if value else "differs"
    paper, shown = statement["number"], f"{value:.3g}"
    off = abs(value - paper)
    if "within" in statement:  # absolute
        return shown, "holds" if off <= statement["within"] else f"differs by {value - paper:+.2g}"
    share = off / abs(paper)
    if share <= 0.05:
        return shown, "holds"
    return shown, f"holds within {100 * share:.0f} %" if share <= 0.1 else f"differs by {100 * (value / paper - 1):+.0f} %"


def filled(text, names):
    """`text` with its {expressions}; what is not run is left out with its braces."""
    try:
        return eval("f" + repr(text), ALLOWED, names)
    except NotRun as missing:
        return f"({missing} not run)"


def by_other_definitions(statement, names):
    """The same statement, measured in other ways that its words allow."""
    told = []
    for definition, expression in statement.get("others", {}).items():
        try:
            told.append("{}: {}, {}".format(definition, *judged(statement, eval(expression, ALLOWED, names))))
        except NotRun:
            told.append(f"{definition}: -")
    return "; ".join(told)


def row_of(statement, results):
    results.used, results.rising = {}, []
    if "seen" in statement:  # read off a picture of the report
        return {**{c: statement.get(c, "") for c in COLUMNS}, "measured": statement["seen"], "source": "picture"}
    names = results.functions()
    others = by_other_definitions(statement, names)
    results.used, results.rising = {}, []
    explanation = filled(statement.get("explanation", ""), names)
    results.used, results.rising = {}, []
    try:
        value = eval(statement["value"], ALLOWED, names)
        measured, verdict = judged(statement, value)
        if "detail" in statement:
            measured += f" ({filled(statement['detail'], names)})"
    except NotRun as missing:
        measured, verdict = f"{missing} not run", "open"
    if results.rising:
        measured += f", so far: {results.rising[0]}"
        if verdict.startswith("differs by -") or verdict == "differs" or statement.get("settled"):
            verdict = "open"
    kinds = sorted(set(results.used.values()))
    return {"id": statement["id"], "figure": statement["figure"], "statement": statement["statement"],
            "paper": str(statement.get("paper", statement.get("number", ""))), "measured": measured, "verdict": verdict,
            "other definitions": others, "source": "+".join(kinds), "cases": " ".join(results.used), "explanation": explanation}


def rows_of(folder):
    results = Results(folder)
    return [row_of(s, results) for s in json.loads((HERE / "statements.json").read_text())]


def tally(rows):
    held = sum(r["verdict"].startswith("holds") for r in rows)
    differs = sum(r["verdict"].startswith("differs") for r in rows)
    either = sum(r["verdict"].startswith("differs") and ", holds" in r["other definitions"] for r in rows)
    return (f"{len(rows)} statements: {held} hold, {differs} differ ({either} of them hold by another definition), "
            f"{len(rows) - held - differs} open")


def check(rows, folder):
    stored = list(csv.DictReader((folder / "table.csv").open(newline="")))
    if stored != rows:
        changed = [r["id"] for r, s in zip(rows, stored) if r != s] or ["their number"]
        sys.exit(f"results/table.csv is not what the results give: {', '.join(changed)}; run verdicts.py --write")
    ids = [r["id"] for r in rows]
    if len(set(ids)) != len(ids):
        sys.exit("two statements share an id")
    silent = [r["id"] for r in rows if r["verdict"].startswith("differs") and not r["explanation"]]
    if silent:
        sys.exit(f"differs, and nobody says why: {', '.join(silent)}")
    for path in sorted(folder.glob("*/*.json")):
        summary = json.loads(path.read_text())["summary"]
        if not summary.get("git") or len(summary.get("scene_hash", "")) < 8:
            sys.exit(f"{path}: no revision or scene hash")


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--results", type=pathlib.Path, default=HERE / "results")
    for flag in ("--write", "--check", "--markdown", "--screening", "--cost"):
        parser.add_argument(flag, action="store_true")
    options = parser.parse_args()
    if options.screening:
        return screening_table(options.results)
    if options.cost:
        return cost_table(options.results)
    rows = rows_of(options.results)
    if options.write:
        with (options.results / "table.csv").open("w", newline="") as out:
            writer = csv.DictWriter(out, COLUMNS)
            writer.writeheader()
            writer.writerows(rows)
    if options.check:
        check(rows, options.results)
    elif options.markdown:
        print("| figure | statement | paper | measured | verdict |\n|---|---|---|---|---|")
        for r in rows:
            print(f"| {r['figure']} | {r['statement']} | {r['paper']} | {r['measured']} | {r['verdict']} |")
    else:
        for r in rows:
            print(f"{r['id']:<7} {r['verdict']:<22} paper {r['paper']:<24} measured {r['measured']:<34} {r['statement']}"
                  f"{' [' + r['source'] + ']' if r['source'] else ''}")
            if r["other definitions"]:
                print(f"        by {r['other definitions']}")
            if r["explanation"]:
                print(f"        {r['explanation']}")
    print(tally(rows))


if __name__ == "__main__":
    main()
