#include "simulation/load_bar.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "simulation/load_recorder.hpp"
#include "tests/support/bare_spec.hpp"

namespace sandgraph::simulation {
namespace {

io::LoadRow at(double d, double load) {
    io::LoadRow row;
    row.d_over_B = d, row.load = load;
    return row;
}

double half_width(const io::LoadRow& row) { return 0.5 * (row.high - row.low); }

constexpr LoadBarSettings kBar{0.01, 0.04, 0.05};

TEST(LoadBar, StandsAboutTheCorrectedLoad) {
    io::LoadRow row = at(0.01, 100e3);
    LoadBar(kBar).add_to(row, -4e3, 0);
    EXPECT_EQ(row.corrected, 96e3);
    EXPECT_DOUBLE_EQ(0.5 * (row.low + row.high), 96e3);
    EXPECT_NEAR(half_width(row), std::hypot(1e3, 0.4 * 4e3), 1e-6);  // the estimate's own miss
}

TEST(LoadBar, HoldsTheSamplingInterval) {
    io::LoadRow row = at(0.01, 100e3);
    LoadBar(kBar).add_to(row, 0, 2e3);
    EXPECT_NEAR(half_width(row), std::hypot(1e3, 1.96 * 2e3), 1e-6);
}

TEST(LoadBar, WidensPastThePeakAndOnlyThere) {
    LoadBar bar(kBar);
    double before = 0;
    for (int k = 1; k <= 40; ++k) {
        io::LoadRow row = at(0.005 * k, k <= 10 ? 10e3 * k : 100e3 - 1e3 * (k - 10));
        bar.add_to(row, 0, 0);
        if (k <= 10)
            EXPECT_NEAR(half_width(row), 0.01 * row.load, 1e-6);
        else if (k <= 20)
            EXPECT_GT(half_width(row), before);
        else
            EXPECT_NEAR(half_width(row), std::hypot(1e3, 4e3), 1e-6);
        before = half_width(row);
    }
}

// Elastic ground that says it lacks so much work at every step.
class Lacking : public stress::Law {
  public:
    explicit Lacking(std::unique_ptr<stress::Law> law) : law_(std::move(law)) {}
    void initialise(const stress::Batch& b) override { law_->initialise(b); }
    void update(const stress::Batch& b) override { law_->update(b), missing_ += 3; }
    double p_wave_modulus() const override { return law_->p_wave_modulus(); }
    bool audits_load() const override { return true; }
    stress::VirtualWork take_missing_work() override { return {std::exchange(missing_, 0), 4}; }

  private:
    std::unique_ptr<stress::Law> law_;
    double missing_ = 0;
};

Spec pulled() {
    Spec spec = support::bare_spec({0, 0, 0.1, 20, 24});
    spec.ground.extent = {0, 0, 2, 2};
    spec.boundaries = {mpm::Side::mirror, mpm::Side::mirror, mpm::Side::fixed, mpm::Side::free};
    spec.law = [](const mpm::Points& points) {
        return std::make_unique<Lacking>(support::elastic({1e6, 0.3}, [](const mpm::Points&, std::size_t) {
            return Stress{-1e3, -2e3, 0};
        })(points));
    };
    spec.bodies = {{mpm::RigidPlate{1, 1, 0.4, 0.1}, {Vec2(0, 1), 0.005}}};
    spec.bodies[0].plate.rest = {2e3, 1e3, 0, 0};
    spec.width = 0.8;
    return spec;
}

// Virtual work of 3 J/m a step over the travel of a step, of a half model twice that.
TEST(LoadRecorder, CorrectsTheLoadOfTheWholePlate) {
    for (const double factor : {1.0, 2.0}) {
        Simulation simulation(pulled());
        const double step = 0.005 * simulation.state().settings.dt;
        LoadRecorder recorder(10 * step / 0.8 * 0.999, factor, 1);
        int rows = 0;
        for (int k = 0; k < 31; ++k) {
            simulation.step();
            const auto row = recorder.after_step(simulation);
            if (!row || k == 0) continue;
            EXPECT_NEAR(row->corrected - row->load, factor * 3 / step, 1e-6 * factor * 3 / step);
            EXPECT_GT(row->high - row->low, 2 * 1.96 * factor * 2 / (10 * step) * 0.999);
            ++rows;
        }
        EXPECT_GE(rows, 2);
    }
}

}  // namespace
}  // namespace sandgraph::simulation
