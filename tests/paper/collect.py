#!/usr/bin/env python3
"""Boils finished cases down to what the table of statements needs: results/KIND/CASE.json, a few kB each.

    tests/paper/collect.py RUNS [--binary FILE] [--results DIR]

RUNS is what campaign.sh wrote: RUNS/full/CASE and RUNS/screening/CASE.
"""
import argparse
import csv
import io
import json
import pathlib
import subprocess

HERE = pathlib.Path(__file__).parent
KEPT = ["points", "n_gamma", "n_gamma_meyerhof_adams", "n_gamma_biarez", "peak_d_over_B", "late_load_N_per_m",
        "breakout_criterion", "friction_angle_deg", "equivalent_embedment_ratio", "unit_load_N_per_m",
        "kinetic_to_strain_energy_max", "wall_s", "cpu_s", "threads", "dem_steps", "mode", "git", "scene_hash", "audit"]
LOAD_EVERY = 0.01  # d/B between stored loads
REGION_EVERY = 0.01


def thinned(rows, every, key="d_over_B"):
    """The rows nearest below each multiple of `every`, and the last."""
    kept, following = [], 0.0
    for row in rows:
        if float(row[key]) >= following - 1e-9:
            kept.append(row)
            following = (int(float(row[key]) / every + 1e-6) + 1) * every
    if rows and kept[-1] is not rows[-1]:
        kept.append(rows[-1])
    return kept


def number(text):
    return float(f"{float(text):.4g}")


def table(rows, columns):
    return {c: [number(r[c]) for r in rows] for c in columns}


def regions_of(folder):
    path = folder / "regions.csv"
    if not path.exists():
        return {}
    rows = list(csv.DictReader(path.open()))
    out = {}
    for name in sorted({r["region"] for r in rows}):
        own = [r for r in rows if r["region"] == name]
        columns = ["d_over_B"] + [f"{q}_mean" for q in ("p", "q", "K", "porosity", "anisotropy", "strain", "rotation",
                                                        "sigma_xx", "sigma_yy", "sigma_xy")] + ["strain_max", "rotation_max",
                                                                                    "rotation_min"]
        out[name] = {"points": int(own[0]["points"]), **table(thinned(own, REGION_EVERY), columns)}
        for q in ("q", "K", "anisotropy"):  # of every row, as thinning may miss a peak
            top = max(own, key=lambda r: float(r[f"{q}_mean"]) if r[f"{q}_mean"] != "nan" else -1)
            out[name][f"{q}_peak"] = [number(top["d_over_B"]), number(top[f"{q}_mean"])]
    return out


def pattern_of(folder, binary):
    text = subprocess.run([binary, "measure", str(folder)], check=True, capture_output=True, text=True).stdout
    rows = list(csv.DictReader(io.StringIO(text)))
    return table(rows, [c for c in rows[0] if c != "run"]) if rows else {}


def collect(folder, binary):
    summary = json.loads((folder / "summary.json").read_text())
    load = list(csv.DictReader((folder / "load.csv").open()))
    unit = summary["unit_load_N_per_m"]
    thin = thinned(load, LOAD_EVERY)
    return {"case": folder.name,
            "reached": number(load[-1]["d_over_B"]),
            "summary": {k: summary[k] for k in KEPT if k in summary},
            "load": {"d_over_B": [number(r["d_over_B"]) for r in thin],
                     "n": [number(float(r["load_N_per_m"]) / unit) for r in thin]},
            "pattern": pattern_of(folder, binary),
            "regions": regions_of(folder)}


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("runs", type=pathlib.Path)
    parser.add_argument("--binary", default=str(HERE / "../../build/release/sandgraph"))
    parser.add_argument("--results", type=pathlib.Path, default=HERE / "results")
    options = parser.parse_args()
    for summary in sorted(options.runs.glob("*/*/summary.json")):
        folder = summary.parent
        target = options.results / folder.parent.name / f"{folder.name}.json"
        target.parent.mkdir(parents=True, exist_ok=True)
        text = json.dumps(collect(folder, options.binary), separators=(",", ":"), allow_nan=True)
        target.write_text(text.replace("NaN", "null") + "\n")
        print(target)


if __name__ == "__main__":
    main()
