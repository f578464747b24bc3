#include "results/compare_runs.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>

#include "base/error.hpp"
#include "results/field_values.hpp"
#include "results/run_summary.hpp"
#include "results/smoothing.hpp"

namespace sandgraph::results {
namespace {

constexpr double unknown = std::numeric_limits<double>::quiet_NaN();
constexpr double kSameFrame = 2e-4;   // in d/B
constexpr double kSmoothing = 0.005;  // half width, in d/B
constexpr double kFloor = 1000;       // [Pa]
constexpr double kSameEnd = 0.002;    // of two curves, in d/B

struct Curve {
    std::vector<double> d, load;
};

Curve curve_of(const FinishedRun& run) {
    Curve c;
    for (const io::LoadRow& row : run.record.load) c.d.push_back(row.d_over_B), c.load.push_back(row.load);
    return c;
}

double at(const Curve& c, double d) {
    const auto k = static_cast<std::size_t>(std::lower_bound(c.d.begin(), c.d.end(), d) - c.d.begin());
    if (k == 0) return c.load.front();
    const double w = (d - c.d[k - 1]) / (c.d[k] - c.d[k - 1]);
    return c.load[k - 1] + w * (c.load[k] - c.load[k - 1]);
}

// Over the reference's abscissae that the other curve covers.
double rms_difference(const Curve& reference, const Curve& other) {
    std::vector<double> a, b;
    for (std::size_t k = 0; k < reference.d.size(); ++k)
        if (!other.d.empty() && reference.d[k] <= other.d.back()) {
            a.push_back(reference.load[k]);
            b.push_back(at(other, reference.d[k]));
        }
    return a.empty() ? unknown : results::rms_difference(a, b);
}

Curve smoothed(const Curve& c) { return {c.d, smooth(c.d, c.load, kSmoothing).value}; }

double end_of(const FinishedRun& run) {
    return run.record.load.empty() ? 0 : run.record.load.back().d_over_B;
}

void compare_loads(const FinishedRun& reference, const FinishedRun& other, Comparison& out) {
    const double peak = reference.summary.breakout_load;
    const bool both_broke_out = reference.summary.breakout && other.summary.breakout;
    if (both_broke_out || std::abs(end_of(reference) - end_of(other)) < kSameEnd) {
        out.peak_error = std::abs(other.summary.breakout_load - peak) / peak;
        out.peak_position_error =
            std::abs(other.summary.breakout_d_over_B - reference.summary.breakout_d_over_B);
    }
    const Curve a = curve_of(reference), b = curve_of(other);
    out.curve_error = rms_difference(a, b) / peak;
    out.curve_error_smoothed = rms_difference(smoothed(a), smoothed(b)) / peak;
}

struct FieldSums {
    double displacement = 0, stress = 0;  // mean squares over the points
};

FieldSums compare_frames(const io::Frame& a, const io::Frame& b, double pull) {
    const io::Field &ua = field(a, "displacement", 2), &ub = field(b, "displacement", 2);
    const io::Field &sa = field(a, "stress", 3), &sb = field(b, "stress", 3);
    const std::size_t n = a.x.size();
    FieldSums sum;
    for (std::size_t p = 0; p < n; ++p) {
        const auto u = [&](int i) { return ua.values[2 * p + i] - ub.values[2 * p + i]; };
        const auto s = [&](int i) { return sa.values[3 * p + i] - sb.values[3 * p + i]; };
        const double scale = std::max(0.5 * (sa.values[3 * p] + sa.values[3 * p + 1]), kFloor);
        sum.displacement += (u(0) * u(0) + u(1) * u(1)) / (pull * pull);
        sum.stress += (s(0) * s(0) + s(1) * s(1) + 2 * s(2) * s(2)) / (scale * scale);
    }
    return {sum.displacement / static_cast<double>(n), sum.stress / static_cast<double>(n)};
}

void compare_fields(const FinishedRun& reference, const FinishedRun& other, Comparison& out) {
    FieldSums sum;
    for (std::size_t i = 0; i < reference.record.frames; ++i) {
        const io::Frame a = io::read_run_frame(reference.frame_file(), i);
        for (std::size_t k = 0; k < other.record.frames && a.d_over_B > kSameFrame; ++k) {
            const io::Frame b = io::read_run_frame(other.frame_file(), k);
            if (std::abs(a.d_over_B - b.d_over_B) > kSameFrame) continue;
            const FieldSums one = compare_frames(a, b, a.d_over_B * reference.scene.anchor.width);
            sum.displacement += one.displacement, sum.stress += one.stress;
            ++out.frames;
        }
    }
    out.displacement_error = out.frames ? std::sqrt(sum.displacement / out.frames) : unknown;
    out.stress_error = out.frames ? std::sqrt(sum.stress / out.frames) : unknown;
}

// One list serves both forms.
template <class Visit>
void visit(const Comparison& c, Visit&& one) {
    one("common_d_over_B", c.common, "up to which both runs go");
    one("peak_error", c.peak_error, "share of the reference's peak load");
    one("peak_position_error", c.peak_position_error, "in d/B");
    one("curve_error", c.curve_error, "rms over the load curve, share of the peak");
    one("curve_error_smoothed", c.curve_error_smoothed, "the same, smoothed over 0.005 in d/B");
    one("displacement_error", c.displacement_error, "rms over points and frames, share of the pull");
    one("stress_error", c.stress_error, "rms over points and frames, share of max(p, 1 kPa)");
    one("frames", c.frames, "common field frames");
    one("wall_ratio", c.wall_ratio, "times faster by wall clock");
    one("cpu_ratio", c.cpu_ratio, "times less processor time");
    one("dem_fraction_mean", c.dem_share_mean, "share of points answered by grains, over the run");
    one("dem_fraction_final", c.dem_share, "at its end");
    one("audit_stress_error_mean", c.audit_mean, "the run's own estimate, share of p");
    one("audit_ci95", c.audit_ci95, "half width of its 95 % interval");
    one("jump_p95", c.jump_p95, "stress jump at hand-over, share of p");
    one("jump_felt_p95", c.felt_p95, "largest step of the ground's stress while it fades, share of p");
    one("ordinary_step_p95", c.ordinary_p95, "the same points' largest step after that, share of p");
    one("replay_share", c.replay_share, "of its DEM steps: catching up at hand-over");
}

}  // namespace

Comparison compare_runs(const FinishedRun& reference, const FinishedRun& other) {
    if (reference.summary.points != other.summary.points)
        throw InputError(
            {other.folder.string()}, "another ground than the reference",
            fmt::format("{} points instead of {}", other.summary.points, reference.summary.points),
            "compare runs of scenes that differ in how they are computed");
    Comparison out;
    compare_loads(reference, other, out);
    compare_fields(reference, other, out);
    out.common = std::min(end_of(reference), end_of(other));
    const bool same_length = std::abs(end_of(reference) - end_of(other)) < kSameEnd;
    out.wall_ratio = same_length ? reference.summary.wall_s / other.summary.wall_s : unknown;
    out.cpu_ratio = same_length ? reference.summary.cpu_s / other.summary.cpu_s : unknown;
    out.dem_share_mean = other.summary.dem_fraction_mean, out.dem_share = other.summary.dem_fraction_final;
    out.audit_mean = other.summary.audit.stress_error_mean, out.audit_ci95 = other.summary.audit.ci95;
    out.jump_p95 = other.summary.number("jump_p95"), out.felt_p95 = other.summary.number("jump_felt_p95");
    out.ordinary_p95 = other.summary.number("ordinary_step_p95");
    out.replay_share = other.summary.number("dem_steps_replay") /
                       std::max(1.0, static_cast<double>(other.summary.dem_steps));
    return out;
}

std::string to_text(const Comparison& c) {
    std::string out;
    visit(c, [&](const char* name, double value, const char* meaning) {
        out += fmt::format("{:<24} {:>10}  {}\n", name,
                           std::isnan(value) ? "-" : fmt::format("{:.4g}", value), meaning);
    });
    return out;
}

std::string to_json(const Comparison& c) {
    nlohmann::ordered_json json;
    visit(c, [&](const char* name, double value, const char*) { json[name] = value; });
    return json.dump(2) + "\n";
}

}  // namespace sandgraph::results
