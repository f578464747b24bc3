#!/usr/bin/env python3
"""How much less the load scatters between seeds when a ground is dealt from several base packings.

    tests/bench/sample_scatter.py RUNS_FOLDER results.csv [--seeds 6] [--program build/release/sandgraph]

A small scene (H/B = 2, cells of 0.125 m, packings of 100 grains, to just past the peak), dense and loose, grains.samples
= 1, 4 and 16, grains.seed = 1, 2, ...; what is there is not run again. Half an hour of two cores, most of it packings.
"""
import argparse
import csv
import json
import math
import pathlib
import statistics
import subprocess

DENSITIES, SAMPLES = ("dense", "loose"), (1, 4, 16)
SCENE = ("domain.width=2.5 m", "domain.depth=3.25 m", "grains.count=100", "output.pictures=false", "output.frames=[0]")
UNTIL = {"dense": 0.03, "loose": 0.06}  # d/B


def run(program, folder, density, samples, seed):
    out = folder / f"{density}-{samples}-{seed}"
    if not (out / "summary.json").exists():
        keys = SCENE + (f"grains.density={density}", f"grains.samples={samples}", f"grains.seed={seed}")
        command = [program, "run", "configs/quick.toml", "-o", str(out), "--until", str(UNTIL[density])]
        subprocess.run(command + [word for key in keys for word in ("--set", key)], check=True, capture_output=True)
    summary = json.loads((out / "summary.json").read_text())
    return summary["peak_load_N_per_m"] / (summary["density_kg_per_m3"] * 9.81 * 2), summary


def measure(program, folder, seeds):
    for density in DENSITIES:
        for samples in SAMPLES:
            for seed in range(1, seeds + 1):
                factor, summary = run(program, folder, density, samples, seed)
                yield [density, samples, seed, f"{factor:.4f}", f"{summary['friction_angle_packing_deg']:.2f}"]


def table(rows):
    print("density samples seeds  mean N  sd of N  of the mean  (of one / root of samples)")
    for density in DENSITIES:
        one = None
        for samples in SAMPLES:
            factors = [float(r[3]) for r in rows if r[0] == density and r[1] == samples]
            mean, sd = statistics.mean(factors), statistics.stdev(factors)
            one = one or sd
            print(f"{density:7} {samples:7} {len(factors):5}  {mean:6.3f}  {sd:7.3f}  {100 * sd / mean:9.1f} %"
                  f"  {100 * one / math.sqrt(samples) / mean:9.1f} %")


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("folder", type=pathlib.Path)
    parser.add_argument("results", type=pathlib.Path)
    parser.add_argument("--seeds", type=int, default=6)
    parser.add_argument("--program", default="build/release/sandgraph")
    options = parser.parse_args()
    rows = list(measure(options.program, options.folder, options.seeds))
    with options.results.open("w") as out:
        csv.writer(out, lineterminator="\n").writerows([["density", "samples", "seed", "n", "friction_deg"]] + rows)
    table(rows)


if __name__ == "__main__":
    main()
