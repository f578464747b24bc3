#include <gtest/gtest.h>

#include <cmath>
#include <numeric>

#include "tests/support/bare_spec.hpp"

namespace sandgraph {
namespace {

constexpr double H = 10, density = 1000, young = 1e9, gravity = 9.81;

struct Swing {
    double peak = 0, period = 0;  // mean settlement [m], [s]
};

simulation::Spec column(int cells, int per_cell) {
    const double cell = H / cells;
    simulation::Spec spec = support::bare_spec({0, 0, cell, 2, cells + 2});
    spec.ground.extent = {0, 0, 2 * cell, H};
    spec.ground.points_per_cell = per_cell;
    spec.ground.density = density;
    spec.law = support::elastic({young, 0});
    spec.gravity = {0, -gravity};
    spec.boundaries = {mpm::Side::mirror, mpm::Side::mirror, mpm::Side::fixed, mpm::Side::free};
    spec.scheme.courant = 0.02;
    return spec;
}

double mean_height(const mpm::Points& points) {
    return std::accumulate(points.y.begin(), points.y.end(), 0.0) / static_cast<double>(points.size());
}

// The peak, and the period between two upward crossings of the static mean, interpolated.
Swing swing(simulation::Simulation& model, double rest) {
    Swing s;
    const double start = mean_height(model.state().points), dt = model.state().settings.dt;
    std::vector<double> crossings;
    for (double old = 0, t = 0; crossings.size() < 2 && t < 0.06; t += dt) {
        model.step();
        const double settlement = start - mean_height(model.state().points);
        s.peak = std::max(s.peak, settlement);
        if (old < rest && settlement >= rest) crossings.push_back(t + dt * (rest - old) / (settlement - old));
        old = settlement;
    }
    if (crossings.size() == 2) s.period = crossings[1] - crossings[0];
    return s;
}

struct Case {
    int cells, per_cell;
    double tolerance;
};

class GravityColumn : public testing::TestWithParam<Case> {};

TEST_P(GravityColumn, SettlesTwiceTheStaticMeanAndComesBack) {
    simulation::Simulation model(column(GetParam().cells, GetParam().per_cell));
    const double exact = 2 * density * gravity * H * H / (3 * young),
                 period = 4 * H / std::sqrt(young / density);
    const Swing s = swing(model, exact / 2);
    EXPECT_NEAR(s.peak, exact, GetParam().tolerance * exact);
    EXPECT_NEAR(s.period, period, GetParam().tolerance * period);
    RecordProperty("peak_error_percent", std::to_string(100 * (s.peak / exact - 1)));
    RecordProperty("period_error_percent", std::to_string(100 * (s.period / period - 1)));
}

INSTANTIATE_TEST_SUITE_P(Refinement, GravityColumn,
                         testing::Values(Case{10, 4, 0.004}, Case{20, 4, 0.0015}, Case{40, 4, 0.0005},
                                         Case{10, 1, 0.009}, Case{20, 1, 0.002}, Case{40, 1, 0.0005}),
                         [](const auto& test) {
                             return std::to_string(test.param.cells) + "Cells" +
                                    std::to_string(test.param.per_cell) + "PerCell";
                         });

}  // namespace
}  // namespace sandgraph
