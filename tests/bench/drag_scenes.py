#!/usr/bin/env python3
"""Whether plates at the default rate are slow enough: random Mohr-Coulomb scenes at the default rate of a program
and at a slower one. Prints a line a scene: N at both rates, what they part by, and what the run itself says of
the load that damping, PIC and inertia carry.

    tests/bench/drag_scenes.py build/release/sandgraph [--scenes 20] [--slower 8] [--set KEY=VALUE ...]
"""
import argparse
import csv
import json
import math
import pathlib
import random
import subprocess
import tempfile


def draw(rng):
    """One scene: B 0.3 to 2 m, H/B 1 to 4, eight cells a width, up or sideways."""
    up = rng.random() < 0.6
    s = dict(up=up, B=round(rng.uniform(0.3, 2), 1), ratio=round(8 * rng.uniform(1, 4 if up else 2.5)) / 8,
             surcharge=rng.choice([0, round(rng.uniform(0, 20), 1)]), E=round(math.exp(rng.uniform(3.0, 5.3)), 1),
             phi=round(rng.uniform(23, 38), 1), psi=round(rng.uniform(0, 10), 1), points=rng.choice([1, 1, 4]))
    return s


def text(s, until):
    B, h, H, tan = s["B"], s["B"] / 8, s["ratio"] * s["B"], math.tan
    phi = math.radians(s["phi"])
    ahead, behind = H * tan(math.pi / 4 + phi / 2), max(B + h / 2, H * tan(math.pi / 4 - phi / 2) + h / 2)
    position = (math.ceil(behind / h) + 0.5) * h
    width = 0.6 * B + H * tan(phi) + B if s["up"] else position + B + max(ahead, B)
    depth = math.ceil((H + 1.2 * B) / h - 1e-6) * h
    place = "" if s["up"] else f'position = "{position:.6g} m"\norientation = "vertical"\n'
    return f"""[domain]
width = "{math.ceil(width / h - 1e-6) * h:.6g} m"
depth = "{depth:.6g} m"
cell = "{h:.6g} m"
points_per_cell = {s["points"]}
[anchor]
{place}width = "{B:.6g} m"
thickness = "{h:.6g} m"
embedment_ratio = {s["ratio"]}
pull_to = {until}
[ground]
law = "mohr_coulomb"
surcharge = "{s["surcharge"]} kPa"
[continuum]
young = "{s["E"]} MPa"
friction_angle = "{s["phi"]} deg"
dilation_angle = "{s["psi"]} deg"
[output]
frames = [0]
"""


def run(program, scene, folder, overrides):
    command = [program, "run", scene, "-o", folder, "--threads", "1"]
    for o in overrides:
        command += ["--set", o]
    subprocess.run([str(c) for c in command], check=True, capture_output=True)
    summary = json.loads((folder / "summary.json").read_text())
    rows = [{k: float(v) for k, v in row.items()} for row in csv.DictReader(open(folder / "load.csv"))]
    return summary, rows


def late(summary, rows):
    half = [r["load_N_per_m"] for r in rows if r["d_over_B"] > 0.5 * rows[-1]["d_over_B"]]
    return sum(half) / len(half) / summary["unit_load_N_per_m"]


def shares(rows, at):
    """Of the load about d/B = at, in per cent."""
    near = [r for r in rows if abs(r["d_over_B"] - at) <= 0.005 and r["d_over_B"] > 0]
    load = sum(r["load_N_per_m"] for r in near)
    names = ("damping_share", "pic_share", "inertia_share")
    return [100 * sum(r[n] * r["load_N_per_m"] for r in near) / load for n in names] if names[0] in rows[0] else [0] * 3


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("program", type=pathlib.Path)
    parser.add_argument("--scenes", type=int, default=20)
    parser.add_argument("--first", type=int, default=0)
    parser.add_argument("--seed", type=int, default=17)
    parser.add_argument("--slower", type=float, default=8)
    parser.add_argument("--until", type=float, default=0.02)
    parser.add_argument("--set", action="append", default=[], dest="overrides")
    parser.add_argument("--fast-only", action="store_true", help="no slower run: what the run says of itself")
    a = parser.parse_args()
    rng = random.Random(a.seed)
    scenes = [draw(rng) for _ in range(a.scenes)]
    print("case plate B H/B  q  E phi psi ppc | rate steps  N_fast N_slow peak_% late_% | damping pic inertia sum %")
    with tempfile.TemporaryDirectory() as work:
        for k, s in list(enumerate(scenes))[a.first:]:
            file = pathlib.Path(work) / f"{k}.toml"
            file.write_text(text(s, a.until))
            fast, rows = run(a.program, file, pathlib.Path(work) / f"{k}f", a.overrides)
            rate = fast.get("pull_rate_m_per_s", 0.05)
            for o in a.overrides:
                if o.startswith("anchor.pull_rate="):
                    rate = float(o.split("=")[1].split()[0])
            unit = fast["unit_load_N_per_m"]
            n_slow, parts, late_parts = math.nan, math.nan, math.nan
            if not a.fast_only:
                slow, slow_rows = run(a.program, file, pathlib.Path(work) / f"{k}s",
                                      a.overrides + [f"anchor.pull_rate={rate / a.slower:.9g} m/s"])
                n_slow = slow["peak_load_N_per_m"] / unit
                parts = 100 * (fast["peak_load_N_per_m"] / slow["peak_load_N_per_m"] - 1)
                late_parts = 100 * (late(fast, rows) / late(slow, slow_rows) - 1)
            d = shares(rows, fast["peak_d_over_B"])
            print(f"{k:3d} {'up' if s['up'] else 'side':4s} {s['B']:.1f} {s['ratio']:.2f} {s['surcharge']:4.1f} {s['E']:5.1f} "
                  f"{s['phi']:.1f} {s['psi']:4.1f} {s['points']} | {rate:.4f} {fast['steps']:6d}  "
                  f"{fast['peak_load_N_per_m'] / unit:.3f} {n_slow:.3f} {parts:+6.2f} {late_parts:+6.2f} | "
                  f"{d[0]:.2f} {d[1]:.2f} {d[2]:+.2f} {sum(d):+.2f}", flush=True)


if __name__ == "__main__":
    main()
