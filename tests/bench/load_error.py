#!/usr/bin/env python3
"""What auditors said of a screening run's load, beside what was: load_error.py FULL SCREENING [SCREENING...]

All are run folders of one scene. Curves are smoothed over +-0.005 B; errors are shares of the full run's largest load, rms
over the rows from d/B = 0.002 on, up to its peak and past it; `held` counts rows whose interval holds the full run's load.
"""

import csv
import json
import math
import sys
from bisect import bisect_left
from pathlib import Path

HALF_WINDOW = 0.005
FIRST = 0.002  # d/B


def columns(folder):
    with open(Path(folder) / "load.csv") as file:
        rows = list(csv.DictReader(file))
    return {name: [float(row[name]) for row in rows] for name in rows[0]}


def smooth(d, values):
    def about(x):
        return values[bisect_left(d, x - HALF_WINDOW) : bisect_left(d, x + HALF_WINDOW)]

    return [sum(about(x)) / len(about(x)) for x in d]


def at(x, d, values):
    k = min(max(bisect_left(d, x), 1), len(d) - 1)
    t = (x - d[k - 1]) / (d[k] - d[k - 1])
    return values[k - 1] + t * (values[k] - values[k - 1])


def rms(values):
    return math.sqrt(sum(v * v for v in values) / len(values)) if values else math.nan


def stretch(rows, peak):
    error, left, half = ([row[k] / peak for row in rows] for k in range(3))
    held = sum(abs(e) <= h for e, h in zip(left, half))
    return f"{rms(error):6.1%} {rms(left):6.1%} {rms(half):6.1%} {held:4d} of {len(rows):<4d}"


def main(full_folder, others):
    full = columns(full_folder)
    d, load = full["d_over_B"], smooth(full["d_over_B"], full["load_N_per_m"])
    steps = json.loads((Path(full_folder) / "summary.json").read_text())["dem_steps"]
    print("run: auditors' DEM steps | to the peak: error, left, half width, held | past it: the same")
    for folder in others:
        run = columns(folder)
        x = run["d_over_B"]
        raw, corrected = smooth(x, run["load_N_per_m"]), smooth(x, run["load_corrected_N_per_m"])
        half = smooth(x, [0.5 * (h - l) for h, l in zip(run["load_high_N_per_m"], run["load_low_N_per_m"])])
        end = min(x[-1], d[-1])
        peak, at_peak = max((q, where) for q, where in zip(load, d) if where <= end)
        before, after = [], []
        for k, where in enumerate(x):
            if FIRST <= where <= end:
                true = at(where, d, load)
                (before if where <= at_peak else after).append((true - raw[k], true - corrected[k], half[k]))
        audits = json.loads((Path(folder) / "summary.json").read_text())["dem_steps_load_audit"]
        print(f"{folder}: {audits / steps:.1%} | {stretch(before, peak)} | {stretch(after, peak)}")


if __name__ == "__main__":
    if len(sys.argv) < 3:
        sys.exit(__doc__)
    main(sys.argv[1], sys.argv[2:])
