#include "laboratory/study_history.hpp"

#include <cmath>

#include "base/random.hpp"

namespace sandgraph::laboratory {
namespace {

Mat2 strain(double xx, double xy, double yy) { return (Mat2() << xx, xy, xy, yy).finished(); }
Mat2 shear(double gamma) { return (Mat2() << 0, gamma, 0, 0).finished(); }

void append(StrainHistory& history, const Mat2& gradient, double size, double total) {
    const auto count = static_cast<std::size_t>(std::llround(total / size));
    history.increments.insert(history.increments.end(), count, Mat2::Identity() + size * gradient);
}

}  // namespace

double StrainHistory::length() const {
    double sum = 0;
    for (const Mat2& F : increments) sum += (0.5 * (F + F.transpose()) - Mat2::Identity()).norm();
    return sum;
}

StrainHistory quiet_history() {
    constexpr double noise = 3e-7, trend = 2.5e-8;
    constexpr int steps = 4000;
    StrainHistory history{"quiet", study_pressure, {}};
    Random random(1);
    const auto draw = [&] { return random.uniform(-noise, noise); };
    for (int step = 0; step < steps; ++step) {
        const double xx = draw(), xy = draw(), yx = draw(), yy = draw();
        history.increments.push_back(Mat2::Identity() +
                                     (Mat2() << xx + trend, xy, yx, yy - trend).finished());
    }
    return history;
}

StrainHistory biaxial_history(double total) {
    StrainHistory history{"biaxial", study_pressure, {}};
    append(history, strain(1, 0, -1), 5e-6, total);
    return history;
}

StrainHistory simple_shear_history(double total) {
    StrainHistory history{"simple_shear", study_pressure, {}};
    append(history, shear(1), 5e-6, total);
    return history;
}

StrainHistory reversal_history() {
    StrainHistory history{"reversal", study_pressure, {}};
    append(history, strain(1, 0, -1), 5e-6, 0.005);
    append(history, strain(-1, 0, 1), 5e-6, 0.0025);
    append(history, strain(1, 0, -1), 5e-6, 0.005);
    return history;
}

// The volume grows as a dense packing's does near constant pressure, by 2 % in all, most of it early.
StrainHistory dilating_shear_history(double total) {
    constexpr double size = 5e-5, growth = 0.02, scale = 0.04;
    StrainHistory history{"post_peak", study_pressure, {}};
    for (double gamma = 0; gamma < total - 0.5 * size; gamma += size) {
        const double opening = 0.5 * growth * (std::exp(-gamma / scale) - std::exp(-(gamma + size) / scale));
        history.increments.push_back(Mat2::Identity() + shear(size) + strain(opening, 0, opening));
    }
    history.window = history.increments.size() / 4;
    return history;
}

StrainHistory opening_history() {
    StrainHistory history{"near_zero", study_pressure_low, {}};
    for (int cycle = 0; cycle < 3; ++cycle) {
        append(history, strain(1, 0, 1), 2e-6, 1e-4);
        append(history, strain(-1, 0, -1), 2e-6, 0.8e-4);
    }
    append(history, strain(1, 0, 1), 2e-6, 4e-4);
    return history;
}

StrainHistory recontact_history() {
    StrainHistory history{"recontact", study_pressure_low, {}};
    append(history, strain(1, 0, 1), 1e-5, 0.01);
    append(history, strain(0.2, 0, -0.2), 1e-5, 0.01);
    history.window = history.increments.size() + 950;
    append(history, strain(-1, 0, -1), 1e-5, 0.0105);
    return history;
}

std::vector<StrainHistory> strain_histories(bool quick) {
    const double small = quick ? 0.003 : 0.01, large = quick ? 0.05 : 0.2;
    return {quiet_history(),    biaxial_history(small),        simple_shear_history(small),
            reversal_history(), dilating_shear_history(large), opening_history(),
            recontact_history()};
}

}  // namespace sandgraph::laboratory
