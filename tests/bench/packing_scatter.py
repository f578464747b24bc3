#!/usr/bin/env python3
"""How far a surrogate's load curve is from the mean of several packings of one recipe, and they from each other.

    tests/bench/packing_scatter.py SURROGATE_RUN FULL_RUN FULL_RUN...

Full runs differ in grains.seed alone (tests/paper/campaign.sh 'h-dense-3' 'h-dense-3-seed*'). Differences are rms over
the curve, shares of the mean curve's peak.
"""
import bisect
import csv
import pathlib
import sys

ENDS = (0.1, 0.2, 0.3, 0.4)  # d/B


def curve(run):
    rows = list(csv.DictReader((pathlib.Path(run) / "load.csv").open()))
    d, load = next(iter(rows[0])), list(rows[0])[1]
    return [float(r[d]) for r in rows], [float(r[load]) for r in rows]


def sampled(curve, d_over_B):
    d, load = curve
    return [load[min(len(d) - 1, bisect.bisect_left(d, x))] for x in d_over_B]


def rms(a, b):
    return (sum((x - y) ** 2 for x, y in zip(a, b)) / len(a)) ** 0.5


def main(surrogate, *full):
    curves = [curve(run) for run in full]
    last = min(c[0][-1] for c in curves + [curve(surrogate)])
    print("to d/B  surrogate - mean  one packing - mean  one packing - another")
    for end in [e for e in ENDS if e <= last + 1e-3]:
        d = [x for x in curves[0][0] if x <= end]
        loads = [sampled(c, d) for c in curves]
        mean = [sum(column) / len(loads) for column in zip(*loads)]
        pairs = [rms(a, b) for k, a in enumerate(loads) for b in loads[k + 1:]]
        of_peak = [rms(sampled(curve(surrogate), d), mean), sum(rms(a, mean) for a in loads) / len(loads),
                   sum(pairs) / len(pairs)]
        print(f"{end:6.1f}" + "".join(f"{100 * x / max(mean):17.1f} %" for x in of_peak))


if __name__ == "__main__":
    if len(sys.argv) < 4:
        sys.exit(__doc__)
    main(*sys.argv[1:])
