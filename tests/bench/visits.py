#!/usr/bin/env python3
"""Longer visits of packings against shorter ones: five plates on coarse cells, packings of 200 grains, three seeds.

Prints for each plate, the former settings against `--set KEY=VALUE ...` (none: the default): processor time, DEM steps,
visits, and the error of the load as a share of the former run's peak, up to it and after it.
Usage: tests/bench/visits.py [--sandgraph FILE] [--folder DIR] [--plates NAME ...] [--seeds 1 2 3] [--set KEY=VALUE ...]
"""
import argparse
import csv
import json
import pathlib
import statistics
import subprocess

FORMER = ["rve.update_tolerance=0.0025", "rve.update_change_max=0.05", "rve.predictor=elastic",
          "rve.stress_per_step_max=0.0075", "rve.steps_max=0", "rve.kernel=double"]
# orientation, H/B, width, depth [m], density, surcharge [kPa], end of the pull
PLATES = {"dense": ("horizontal", 3, 4, 5, "dense", 0, 0.04), "loose": ("horizontal", 3, 4, 5, "loose", 0, 0.05),
          "vertical": ("vertical", 3, 9, 5, "dense", 0, 0.05), "deep": ("horizontal", 8, 5, 11, "dense", 0, 0.05),
          "surcharged": ("horizontal", 3, 4, 5, "dense", 100, 0.04)}


def scene(orientation, embedment, width, depth, density, surcharge, _):
    place = 'position = "3.0625 m"\n' if orientation == "vertical" else ""
    return (f'[domain]\nwidth = "{width} m"\ndepth = "{depth} m"\ncell = "0.125 m"\n[anchor]\n{place}'
            f'orientation = "{orientation}"\nembedment_ratio = {embedment}\nthickness = "0.125 m"\n'
            f'pull_rate = "0.05 m/s"\n[ground]\nsurcharge = "{surcharge} kPa"\n'
            f'[grains]\ndensity = "{density}"\ncount = 200\n[output]\nframes = [0]\n')


class Run:
    def __init__(self, args, plate, seed, name, settings):
        folder = pathlib.Path(args.folder) / f"{plate}_{name}_{seed}"
        if not (folder / "summary.json").exists():
            file = pathlib.Path(args.folder) / f"{plate}.toml"
            file.write_text(scene(*PLATES[plate]))
            command = [args.sandgraph, "run", str(file), "-o", str(folder), "--threads", "1", "--until",
                       str(PLATES[plate][-1])]
            for key in [f"grains.seed={seed}", *settings]:
                command += ["--set", key]
            subprocess.run(command, check=True, stdout=subprocess.DEVNULL)
        self.summary = json.loads((folder / "summary.json").read_text())
        rows = list(csv.DictReader(open(folder / "load.csv")))
        self.d = [float(r["d_over_B"]) for r in rows]
        self.load = [float(r["load_N_per_m"]) for r in rows]

    def at(self, d):
        k = next((k for k in range(1, len(self.d)) if self.d[k] >= d), len(self.d) - 1)
        share = (d - self.d[k - 1]) / (self.d[k] - self.d[k - 1])
        return self.load[k - 1] + min(1, share) * (self.load[k] - self.load[k - 1])


def smooth(values, half=5):
    return [statistics.fmean(values[max(0, k - half):k + half + 1]) for k in range(len(values))]


def compare(former, other):
    grid = [0.001 + k * (former.d[-1] - 0.001) / 400 for k in range(401)]
    a, b = [former.at(d) for d in grid], [other.at(d) for d in grid]
    smooth_a, smooth_b = smooth(a), smooth(b)
    peak = max(smooth_a)
    end = smooth_a.index(peak) + 1
    before = [100 * (y - x) / peak for x, y in zip(a[:end], b[:end])]
    after = [100 * (y - x) / peak for x, y in zip(smooth_a[end - 1:], smooth_b[end - 1:])]
    return {"peak": peak, "of_peak": 100 * (max(smooth_b) / peak - 1), "before": statistics.fmean(before),
            "before_rms": statistics.fmean(e * e for e in before) ** 0.5, "after": statistics.fmean(after)}


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("--sandgraph", default="build/release/sandgraph")
    parser.add_argument("--folder", default="out/visits")
    parser.add_argument("--plates", nargs="*", default=list(PLATES), choices=list(PLATES))
    parser.add_argument("--seeds", nargs="*", type=int, default=[1, 2, 3])
    parser.add_argument("--set", nargs="*", default=[], dest="settings")
    args = parser.parse_args()
    pathlib.Path(args.folder).mkdir(parents=True, exist_ok=True)
    name = "_".join(args.settings).replace("rve.", "") or "default"
    for plate in args.plates:
        pairs = [(Run(args, plate, s, "former", FORMER), Run(args, plate, s, name, args.settings)) for s in args.seeds]
        errors = [compare(*pair) for pair in pairs]
        mean = {key: statistics.fmean(e[key] for e in errors) for key in errors[0]}
        scatter = statistics.stdev(e["peak"] for e in errors) / mean["peak"] if len(errors) > 1 else float("nan")
        print(plate, end="")
        for key in ("cpu_s", "dem_steps", "rve_updates"):
            a, b = (statistics.fmean(pair[k].summary[key] for pair in pairs) for k in (0, 1))
            print(f"  {key} {a:.4g} -> {b:.4g} ({a / b:.2f})", end="")
        print("  peaks " + " ".join(f"{e['of_peak']:+.2f}" for e in errors), end=" %")
        print(f"  before {mean['before']:+.2f} % rms {mean['before_rms']:.2f} %  after {mean['after']:+.2f} %"
              f"  packings' scatter {100 * scatter:.1f} %")


if __name__ == "__main__":
    main()
