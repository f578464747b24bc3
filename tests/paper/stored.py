"""What the expressions of statements.json may ask of the stored results."""
import bisect
import csv
import json
import math

STILL_RISING = 2  # summary.json, breakout_criterion


class NotRun(Exception):
    pass


class Results:
    """What expressions may ask. A case not run in full is answered by its screening run; `used` notes it."""

    def __init__(self, folder):
        self.folder, self.cache, self.used, self.rising = folder, {}, {}, []

    def functions(self):
        return {n: getattr(self, n) for n in dir(self) if not n.startswith("_") and callable(getattr(self, n))}

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

    def n_between(self, case, start, end):
        """Mean of the stored loads from d/B = start to end, in units of B gamma H."""
        load = self.case(case, end)["load"]
        return self.mean_between(load, start, end)

    def n_screened(self, case, start, end):
        """The same of its screening run."""
        result = self.find("screening", case)
        if not result or result["reached"] < end - 2e-3:
            raise NotRun(f"{case} by screening")
        return self.mean_between(result["load"], start, end)

    @staticmethod
    def mean_between(load, start, end):
        values = [n for d, n in zip(load["d_over_B"], load["n"]) if start - 1e-3 <= d <= end + 1e-3]
        return sum(values) / len(values)

    def pattern(self, case, column, d):
        pattern = self.case(case, d)["pattern"]
        k = min(range(len(pattern["d_over_B"])), key=lambda i: abs(pattern["d_over_B"][i] - d))
        value = pattern[column][k] if column in pattern else None
        if value is None:
            raise NotRun(case)
        return value

    def region(self, case, name, column, d):
        region = self.case(case, d)["regions"].get(name)
        if not region or column not in region:
            raise NotRun(case)
        return self.interpolated(region["d_over_B"], region[column], d)

    def region_values(self, case, name, column):
        region = self.case(case)["regions"].get(name)
        if not region:
            raise NotRun(case)
        return [v for v in region[column] if v is not None]

    def region_peak(self, case, name, quantity):
        """(d/B, value) of the largest mean."""
        regions = self.case(case)["regions"]
        if name not in regions:
            raise NotRun(case)
        return regions[name][f"{quantity}_peak"]

    def steepest_fall(self, case, after=0.15, over=0.02):
        """(d/B, fall of N) where the load falls most within `over`, late in the pull."""
        load = self.case(case)["load"]
        starts = [d for d in load["d_over_B"] if d >= after and d + over <= load["d_over_B"][-1]]
        return max(((d, self.n_at(case, d) - self.n_at(case, d + over)) for d in starts), key=lambda at: at[1])

    def chains(self, case, name, d):
        """Direction of the larger principal stress [deg from x, anticlockwise], in which force chains run."""
        xx, yy, xy = (self.region(case, name, f"sigma_{c}_mean", d) for c in ("xx", "yy", "xy"))
        return math.degrees(0.5 * math.atan2(2 * xy, xx - yy))

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

    def critical_depth(self, phi):
        """H_cr/B by Table 1 of Meyerhof & Adams (1968); phi in degrees."""
        return self.interpolated([20, 25, 30, 35, 40, 45], [2.5, 3, 4, 5, 7, 9], phi)

    def slip(self, case, column):
        """The vertical surface above the plate's edge (sandgraph measure, slip_*) at the frame nearest the peak."""
        return self.pattern(case, f"slip_{column}", self.d_peak(case))

    def n_at_once(self, case):
        """N if every row of that surface had its largest tan(delta) of the run at the peak load."""
        missing = self.slip(case, "greatest") - self.slip(case, "friction")
        return self.N(case) + self.s(case, "equivalent_embedment_ratio") * self.slip(case, "K") * missing

    @staticmethod
    def interpolated(x, y, at):
        k = bisect.bisect_left(x, at)
        if k == 0:
            return y[0]
        if k == len(x):
            return y[-1]
        t = (at - x[k - 1]) / (x[k] - x[k - 1])
        return y[k - 1] + t * (y[k] - y[k - 1])
