"""Tables over the stored cases that are no verdicts: full fidelity beside the surrogate, and what the runs cost."""
import json

from stored import Results


def stored(folder, kind):
    return {f.stem: json.loads(f.read_text()) for f in sorted((folder / kind).glob("*.json"))}


def summaries(folder, kind):
    return {name: result["summary"] for name, result in stored(folder, kind).items()}


def load_ratio(screening, full):
    """Of loads near full fidelity's peak; of the last that both have where screening stopped before. With the d/B."""
    at = min(full["summary"]["peak_d_over_B"], screening["reached"], full["reached"])
    span = (at - 0.01, at + 0.01)
    return Results.mean_between(screening["load"], *span) / Results.mean_between(full["load"], *span), at


def screening_table(folder):
    print(f"{'case':<14}{'N full':>8}{'N screening':>13}{'off':>8}{'d/B full':>10}{'screening':>11}{'load there':>12}{'cpu full':>10}"
          f"{'screening':>11}{'audit, share of p':>20}")
    full, screening = stored(folder, "full"), stored(folder, "screening")
    for name in sorted(full.keys() & screening.keys()):
        a, b = full[name]["summary"], screening[name]["summary"]
        audit = b.get("audit", {})
        ratio, at = load_ratio(screening[name], full[name])
        print(f"{name:<14}{a['n_gamma']:>8.2f}{b['n_gamma']:>13.2f}{100 * (b['n_gamma'] / a['n_gamma'] - 1):>+7.1f}%"
              f"{a['peak_d_over_B']:>10.3f}{b['peak_d_over_B']:>11.3f}{100 * (ratio - 1):>+11.1f}%{a['cpu_s']:>9.0f}s{b['cpu_s']:>10.0f}s"
              f"{audit.get('stress_error_mean', float('nan')):>12.3f} +- {audit.get('ci95', float('nan')):.3f}"
              + (f"  (load at d/B {at:.2f})" if at < a["peak_d_over_B"] - 1e-3 else ""))


def cost_table(folder):
    print(f"{'case':<18}{'kind':<11}{'revision':<14}{'d/B':>6}{'points':>8}{'DEM steps':>11}{'threads':>8}{'wall':>9}{'processor':>11}")
    for kind in ("full", "screening"):
        runs = summaries(folder, kind)
        for name, s in runs.items():
            reached = json.loads((folder / kind / f"{name}.json").read_text())["reached"]
            print(f"{name:<18}{kind:<11}{s['git']:<14}{reached:>6.2f}{s['points']:>8}{s['dem_steps']:>11.2e}{s['threads']:>8}"
                  f"{s['wall_s']:>8.0f}s{s['cpu_s']:>10.0f}s")
        wall, processor = (sum(s[key] for s in runs.values()) for key in ("wall_s", "cpu_s"))
        print(f"{len(runs)} {kind} runs: wall {wall:.0f} s one after the other, processor {processor:.0f} s, "
              f"{sum(s['dem_steps'] for s in runs.values()):.3g} DEM steps")
