#include "results/load_error.hpp"

#include <fmt/format.h>

#include <cmath>

namespace sandgraph::results {
namespace {

constexpr double kLateShare = 0.1;  // of the curve, as of its late load

struct Means {
    double correction = 0, half_width = 0, rows = 0;
};

Means means_between(std::span<const io::LoadRow> rows, double from, double to) {
    Means m;
    for (const io::LoadRow& row : rows)
        if (row.d_over_B >= from && row.d_over_B <= to)
            m.correction += row.corrected - row.load, m.half_width += 0.5 * (row.high - row.low), ++m.rows;
    return m;
}

}  // namespace

void add_load_error(std::span<const io::LoadRow> rows, const Breakout& breakout, io::Summary::Audit& audit) {
    if (rows.empty() || !(breakout.load > 0)) return;
    const double about = VesicCriterion{}.half_width, end = rows.back().d_over_B;
    const Means peak = means_between(rows, breakout.d_over_B - about, breakout.d_over_B + about);
    const Means late = means_between(rows, end - kLateShare * (end - rows.front().d_over_B), end);
    audit.load_correction = peak.correction / peak.rows / breakout.load;
    audit.load_ci95 = peak.half_width / peak.rows / breakout.load;
    audit.load_ci95_late = late.half_width / late.rows / breakout.load;
}

std::string load_error_text(const io::Summary& s) {
    const io::Summary::Audit& a = s.audit;
    if (std::isnan(a.load_correction)) return "";
    return fmt::format(
        "auditors: peak {:.1f} kN/m, corrected by {:+.1f} kN/m ({:+.1f} +- {:.1f} %); at the end +- {:.1f} % "
        "of the "
        "peak\n",
        s.breakout_load / 1000, a.load_correction * s.breakout_load / 1000, 100 * a.load_correction,
        100 * a.load_ci95, 100 * a.load_ci95_late);
}

}  // namespace sandgraph::results
