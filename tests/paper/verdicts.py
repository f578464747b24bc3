#!/usr/bin/env python3
"""The paper's statements, one by one, beside what our runs say.

    tests/paper/verdicts.py            prints the table from the stored results
    tests/paper/verdicts.py --write    and stores it as results/table.csv
    tests/paper/verdicts.py --check    is results/table.csv what the stored results give?
    tests/paper/verdicts.py --markdown
    tests/paper/verdicts.py --screening   peak of every case run both ways: full fidelity, and the surrogate everywhere

statements.json holds for each statement what the paper says, an expression over the results, and how near is near
enough. To recompute a row from nothing: campaign.sh with the cases in its column `cases`, then collect.py.
"""
import argparse
import bisect
import csv
import json
import math
import pathlib
import sys

HERE = pathlib.Path(__file__).parent
ALLOWED = {"__builtins__": {"abs": abs, "min": min, "max": max}}  # in expressions
STILL_RISING = 2  # summary.json, breakout_criterion
COLUMNS = ["id", "figure", "statement", "paper", "measured", "verdict", "source", "cases", "explanation"]


class NotRun(Exception):
    pass


class Results:
    """What expressions may ask. A case not run in full is answered by its screening run; `used` notes it."""

    def __init__(self, folder):
        self.folder, self.cache, self.used, self.rising = folder, {}, {}, []

    def broken_out(self, name):
        """The case; one that stopped before its load did not rise any more gives a lower bound and is noted."""
        result = self.case(name)
        if result["summary"]["breakout_criterion"] == STILL_RISING and result["reached"] < 0.39:
            self.rising.append(f"{name} to d/B {result['reached']:.2g}")
        return result

    def find(self, kind, name):
        path = self.folder / kind / f"{name}.json"
        if path not in self.cache:
            self.cache[path] = json.loads(path.read_text()) if path.exists() else None
        return self.cache[path]

    def case(self, name, until=0.0):
        for kind in ("full", "screening"):
            result = self.find(kind, name)
            if result and result["reached"] >= until - 2e-3:
                self.used[name] = kind
                return result
        raise NotRun(name)

    def s(self, case, key):
        return self.case(case)["summary"][key]

    def N(self, case):
        return self.broken_out(case)["summary"]["n_gamma"]

    def formula(self, case):
        return self.broken_out(case)["summary"]["n_gamma_meyerhof_adams" if case.startswith("h") else "n_gamma_biarez"]

    def over_formula(self, case):
        return self.N(case) / self.formula(case)

    def d_peak(self, case):
        return self.broken_out(case)["summary"]["peak_d_over_B"]

    def n_at(self, case, d):
        """Load at d/B in units of B gamma H."""
        load = self.case(case, d)["load"]
        return self.interpolated(load["d_over_B"], load["n"], d)

    def pattern(self, case, column, d):
        pattern = self.case(case, d)["pattern"]
        k = min(range(len(pattern["d_over_B"])), key=lambda i: abs(pattern["d_over_B"][i] - d))
        value = pattern[column][k]
        if value is None:
            raise NotRun(case)
        return value

    def region(self, case, name, column, d):
        region = self.case(case, d)["regions"].get(name)
        if not region:
            raise NotRun(case)
        return self.interpolated(region["d_over_B"], region[column], d)

    def region_peak(self, case, name, quantity):
        """(d/B, value) of the largest mean."""
        regions = self.case(case)["regions"]
        if name not in regions:
            raise NotRun(case)
        return regions[name][f"{quantity}_peak"]

    def critical(self, column, pressure=None):
        rows = list(csv.DictReader((self.folder / "critical_state.csv").open()))
        chosen = [float(r[column]) for r in rows if pressure is None or abs(float(r["pressure"]) - pressure) < 1]
        self.used["rve critical"] = "element tests"
        return sum(chosen) / len(chosen)

    def meyerhof_adams(self, ratio, phi, critical):
        side = 0.95 * math.tan(math.radians(phi))
        return ratio * side + 1 if ratio <= critical else (2 - critical / ratio) * critical * side + 1

    def biarez(self, ratio, phi):
        return 4 * math.pi * (1 - 1 / ratio) * math.tan(math.radians(phi))

    @staticmethod
    def interpolated(x, y, at):
        k = bisect.bisect_left(x, at)
        if k == 0:
            return y[0]
        if k == len(x):
            return y[-1]
        t = (at - x[k - 1]) / (x[k] - x[k - 1])
        return y[k - 1] + t * (y[k] - y[k - 1])


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


def row_of(statement, results):
    results.used, results.rising = {}, []
    if "seen" in statement:  # read off a picture of the report
        return {**{c: statement.get(c, "") for c in COLUMNS}, "measured": statement["seen"], "source": "picture"}
    names = {n: getattr(results, n) for n in dir(results) if not n.startswith("_") and callable(getattr(results, n))}
    try:
        value = eval(statement["value"], ALLOWED, names)
        measured, verdict = judged(statement, value)
        if "detail" in statement:
            measured += f" ({eval('f' + repr(statement['detail']), ALLOWED, names)})"
    except NotRun as missing:
        measured, verdict = f"{missing} not run", "open"
    if results.rising:
        measured += f", so far: {results.rising[0]}"
        if verdict.startswith("differs by -") or verdict == "differs" or statement.get("settled"):
            verdict = "open"
    kinds = sorted(set(results.used.values()))
    return {"id": statement["id"], "figure": statement["figure"], "statement": statement["statement"],
            "paper": str(statement.get("paper", statement.get("number", ""))), "measured": measured, "verdict": verdict,
            "source": "+".join(kinds), "cases": " ".join(results.used), "explanation": statement.get("explanation", "")}


def rows_of(folder):
    results = Results(folder)
    return [row_of(s, results) for s in json.loads((HERE / "statements.json").read_text())]


def tally(rows):
    held = sum(r["verdict"].startswith("holds") for r in rows)
    differs = sum(r["verdict"].startswith("differs") for r in rows)
    return f"{len(rows)} statements: {held} hold, {differs} differ, {len(rows) - held - differs} open"


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


def screening_table(folder):
    print(f"{'case':<14}{'N full':>8}{'N screening':>13}{'off':>8}{'d/B full':>10}{'screening':>11}{'cpu full':>10}{'screening':>11}"
          f"{'audit, share of p':>20}")
    for path in sorted((folder / "full").glob("*.json")):
        twin = folder / "screening" / path.name
        if not twin.exists():
            continue
        a, b = (json.loads(f.read_text())["summary"] for f in (path, twin))
        audit = b.get("audit", {})
        print(f"{path.stem:<14}{a['n_gamma']:>8.2f}{b['n_gamma']:>13.2f}{100 * (b['n_gamma'] / a['n_gamma'] - 1):>+7.1f}%"
              f"{a['peak_d_over_B']:>10.3f}{b['peak_d_over_B']:>11.3f}{a['cpu_s']:>9.0f}s{b['cpu_s']:>10.0f}s"
              f"{audit.get('stress_error_mean', float('nan')):>12.3f} +- {audit.get('ci95', float('nan')):.3f}")


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--results", type=pathlib.Path, default=HERE / "results")
    for flag in ("--write", "--check", "--markdown", "--screening"):
        parser.add_argument(flag, action="store_true")
    options = parser.parse_args()
    if options.screening:
        return screening_table(options.results)
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
            if r["explanation"]:
                print(f"        {r['explanation']}")
    print(tally(rows))


if __name__ == "__main__":
    main()
