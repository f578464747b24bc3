#include "simulation/load_bar.hpp"

#include <algorithm>
#include <cmath>

namespace sandgraph::simulation {
namespace {

constexpr double kNormal = 1.96;  // standard errors of a 95 % interval

}  // namespace

double LoadBar::past_peak(double d_over_B) const {
    return std::clamp((d_over_B - peak_d_) / settings_.widens, 0.0, 1.0);
}

void LoadBar::add_to(io::LoadRow& row, double correction, double sampling) {
    if (row.load > peak_) peak_ = row.load, peak_d_ = row.d_over_B;
    const double late = settings_.scatter * past_peak(row.d_over_B);
    const double half = std::hypot(kNormal * sampling, settings_.miss * peak_, late * peak_);
    row.corrected = row.load + correction;
    row.low = row.corrected - half, row.high = row.corrected + half;
}

}  // namespace sandgraph::simulation
