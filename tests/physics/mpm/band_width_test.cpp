#include <fmt/format.h>
#include <gtest/gtest.h>
#include <oneapi/tbb/global_control.h>
#include <oneapi/tbb/task_arena.h>

#include <cmath>
#include <numbers>

#include "mpm/audit.hpp"
#include "scene/read_scene.hpp"
#include "simulation/scene_spec.hpp"
#include "tests/support/memory_archive.hpp"
#include "tests/support/softening_sand.hpp"

namespace sandgraph::simulation {
namespace {

constexpr double degree = std::numbers::pi / 180;

// A plate at H/B = 1 in sand that softens from 43 to 33 deg over a shear of 0.15.
struct Pull {
    std::unique_ptr<Simulation> model;
    double unit = 1;

    Pull(const std::string& length, int cells, const std::vector<std::string>& more = {}) {
        std::vector<std::string> set = {"ground.internal_length=" + length + " m",
                                        fmt::format("domain.cell={:.17g} m", 1.0 / cells)};
        set.insert(set.end(), more.begin(), more.end());
        const scene::Scene scene = scene::parse_scene(R"(
[domain]
width = "3 m"
depth = "3 m"
[anchor]
thickness = "0.25 m"
embedment_ratio = 1
pull_to = 0.1
pull_rate = "0.1 m/s"
[ground]
law = "mohr_coulomb"
)",
                                                      "s.toml", set);
        const packings::PreparedGround ground = packings::prepare_ground(scene);
        Spec spec = spec_of(scene, ground);
        spec.law = [&](const mpm::Points& points) {
            std::vector<Stress> initial;
            for (const auto row : points.row) {
                const double s = -ground.row_pressure[static_cast<std::size_t>(row)];
                initial.push_back({s, s, 0});
            }
            support::SofteningConstants c;
            c.peak.friction_angle = 43 * degree, c.peak.dilation_angle = 12 * degree;
            c.residual.friction_angle = 33 * degree, c.shear = 0.15;
            return std::make_unique<support::SofteningSand>(c, std::move(initial));
        };
        model = std::make_unique<Simulation>(spec);
        unit = unit_load(scene, ground) / whole_plate_factor(scene);
    }
    // Mean load factor between two travels.
    double factor(double from, double to) const {
        double sum = 0, count = 0;
        while (model->d_over_B() < to) {
            model->step();
            if (model->d_over_B() > from) sum += model->load() / unit, count += 1;
        }
        return sum / count;
    }
    void steps(int count) const {
        for (int k = 0; k < count; ++k) model->step();
    }
    const mpm::Points& points() const { return model->state().points; }
};

// With a length of three and a half and of five cells.
TEST(BandWidth, MakesTheFallingLoadHangLessOnTheMesh) {
    const auto change = [](const std::string& length) {
        const double coarse = Pull(length, 12).factor(0.05, 0.07), fine = Pull(length, 16).factor(0.05, 0.07);
        return std::fabs(coarse - fine) / fine;
    };
    const double local = change("0"), own = change("0.3");
    RecordProperty("local", std::to_string(local));
    RecordProperty("own", std::to_string(own));
    EXPECT_LT(own, 0.03);
    EXPECT_LT(own, 0.6 * local);
}

TEST(BandWidth, LeavesGroundAtRestAtRest) {
    const Pull pull("0.25", 8);  // the plate rests for 0.05 s
    const std::vector<Stress> before = pull.points().stress;
    while (pull.model->time() < 0.045) pull.steps(1);
    for (std::size_t p = 0; p < before.size(); ++p)
        EXPECT_NEAR(pull.points().stress[p].xy, before[p].xy, 1e-6 * -before[p].yy);
    EXPECT_LT(mpm::kinetic_energy(pull.points()), 1e-12);
}

TEST(BandWidth, GoesOnFromACheckpointBitForBit) {
    const Pull straight("0.25", 8), resumed("0.25", 8);
    straight.steps(900);
    support::MemoryArchive memory;
    straight.model->archive(memory);
    memory.read_from_now_on();
    resumed.model->archive(memory);
    straight.steps(100), resumed.steps(100);
    EXPECT_EQ(straight.points().x, resumed.points().x);
    EXPECT_EQ(straight.points().stress, resumed.points().stress);
    EXPECT_EQ(straight.model->state().stress_work, resumed.model->state().stress_work);
}

TEST(BandWidth, IsTheSameOnAnyThreads) {
    const oneapi::tbb::global_control four(oneapi::tbb::global_control::max_allowed_parallelism, 4);
    const auto on = [](int threads) {
        oneapi::tbb::task_arena arena(threads);
        return arena.execute([] {
            const Pull pull("0.25", 16, {"domain.points_per_cell=4"});
            pull.steps(150);
            return std::pair(pull.points().x, pull.points().stress);
        });
    };
    EXPECT_EQ(on(1), on(4));
}

// Of four points a cell the cell's mean strain and stress.
TEST(BandWidth, ClosesTheEnergyBalance) {
    for (const char* points : {"1", "4"}) {
        const Pull pull("0.25", 8, {std::string("domain.points_per_cell=") + points});
        Simulation& model = *pull.model;
        const graph::GroundState& s = model.state();
        const double start = mpm::gravity_potential(pull.points(), {0, -9.81});
        double work = 0;
        while (model.d_over_B() < 0.06) {
            model.step();
            work += mpm::plate_work(s.bodies[0].plate, s.bodies[0].contact.reaction, s.settings.dt);
        }
        const double kinetic = mpm::kinetic_energy(pull.points());
        const double stored = s.stress_work + mpm::gravity_potential(pull.points(), {0, -9.81}) - start;
        const double lost = s.node_work.damping + s.node_work.gained - kinetic;  // damping, transfer
        EXPECT_NEAR((stored + kinetic + lost) / work, 1, 0.02) << points;
    }
}

}  // namespace
}  // namespace sandgraph::simulation
