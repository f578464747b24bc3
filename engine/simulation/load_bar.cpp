#include "simulation/load_bar.hpp"

#include <algorithm>
#include <cmath>

namespace sandgraph::simulation {
namespace {

constexpr double kNormal = 1.96;  // standard errors of a 95 % interval
// A correction is of first order: a ground with the grains' stresses would move otherwise. What it leaves of
// a large error, half of a 95 % interval, share of the correction (as measured as LoadBarSettings is).
constexpr double kSecondOrder = 0.4;

}  // namespace

double LoadBar::past_peak(double d_over_B) const {
    return std::clamp((d_over_B - peak_d_) / settings_.widens, 0.0, 1.0);
}

void LoadBar::add_to(io::LoadRow& row, double correction, double sampling) {
    if (row.load > peak_) peak_ = row.load, peak_d_ = row.d_over_B;
    const double late = settings_.scatter * past_peak(row.d_over_B);
    const double estimate = std::hypot(settings_.miss * peak_, kSecondOrder * correction);
    const double half = std::hypot(kNormal * sampling, estimate, late * peak_);
    row.corrected = row.load + correction;
    row.low = row.corrected - half, row.high = row.corrected + half;
}

}  // namespace sandgraph::simulation
