#include <gtest/gtest.h>

#include <algorithm>

#include "base/random.hpp"
#include "graph/access_check.hpp"
#include "graph/step_graph.hpp"
#include "graph/step_phases.hpp"
#include "memory_archive.hpp"
#include "small_pull.hpp"

// What the phases of a real step say of the data that they touch is true.
namespace sandgraph::graph {
namespace {

using MakePull = std::unique_ptr<simulation::Simulation> (*)();
class RealPhases : public testing::TestWithParam<MakePull> {};

constexpr int kSteps = 40;

std::unique_ptr<simulation::Simulation> moving(MakePull make) {
    auto pull = make();
    pull->state().bodies.front().plate.velocity = Vec2(0, 0.05);
    return pull;
}

TEST_P(RealPhases, GiveTheSameBitsInWhateverOrderTheyAreListed) {
    std::string first;
    Random random(7);
    for (int trial = 0; trial < 4; ++trial) {
        const auto pull = moving(GetParam());
        std::vector<Phase> phases = step_phases(pull->state());
        for (std::size_t k = phases.size(); k > 1 && trial > 0; --k)
            std::swap(phases[k - 1], phases[random.bits() % k]);
        StepGraph graph(std::move(phases));
        for (int step = 0; step < kSteps; ++step) graph.run();
        const std::string bits = support::digest(*pull);
        if (trial == 0) first = bits;
        EXPECT_EQ(bits, first) << "trial " << trial;
    }
}

TEST_P(RealPhases, ChangeOnlyWhatTheySayTheyWrite) {
    const auto pull = moving(GetParam());
    const std::vector<Phase> phases = step_phases(pull->state());
    for (int step = 0; step < kSteps; ++step) ASSERT_NO_THROW(run_checked(phases, pull->state()));
}

TEST_P(RealPhases, APhaseThatHidesAWriteIsFound) {
    const auto pull = moving(GetParam());
    std::vector<Phase> phases = step_phases(pull->state());
    for (Phase& phase : phases)
        if (phase.name == "grid update") std::erase(phase.writes, Version{Data::bodies, 1});
    EXPECT_THROW(run_checked(phases, pull->state()), std::logic_error);
}

// The state of a step, to be put back.
class Snapshot {
  public:
    explicit Snapshot(GroundState& s)
        : points_(s.points),
          grid_(s.grid),
          order_(s.order),
          bodies_(s.bodies),
          work_{s.stress_work, s.work_before, s.node_work.damping, s.node_work.gained} {
        s.law->archive(law_);
        law_.read_from_now_on();
    }
    void restore(GroundState& s) {
        s.points = points_, s.grid = grid_, s.order = order_, s.bodies = bodies_;
        s.stress_work = work_[0], s.work_before = work_[1];
        s.node_work = {work_[2], work_[3]};
        s.law->archive(law_);
    }

  private:
    mpm::Points points_;
    mpm::Grid grid_;
    mpm::Order order_;
    std::vector<Body> bodies_;
    double work_[4];
    support::MemoryArchive law_;
};

// Moves a datum a little, such that whoever reads it gets something else.
void spoil(GroundState& s, Data data) {
    for (std::size_t p = 0; p < s.points.size(); ++p) {
        if (data == Data::points) s.points.vx[p] += 1e-3, s.points.volume[p] *= 1.001, s.points.y[p] += 1e-5;
        if (data == Data::increments) s.points.F_inc[p](0, 0) += 1e-5;
        if (data == Data::stress) s.points.stress[p].xx *= 1.001;
        if (data == Data::contact) s.bodies.front().contact.slip[p] += 1e-5;
    }
    if (data == Data::grid)
        for (mpm::Field& field : s.grid.fields) {
            for (mpm::Node& n : field.nodes) n.mass *= 1.001, n.fx += 1;
            for (mpm::Motion& m : field.motion) m.vx += 1e-3;
        }
    if (data == Data::bodies) s.bodies.front().plate.y += 1e-4, s.bodies.front().plate.velocity.y() += 1e-3;
    if (data == Data::energy) s.stress_work += 1, s.work_before += 1;
}

bool names(const Phase& phase, Data data) {
    const auto is = [&](const Version& v) { return v.data == data; };
    return std::ranges::any_of(phase.reads, is) || std::ranges::any_of(phase.writes, is);
}

// A phase whose result hangs on a datum that it does not name reads it in secret: "phase: datum" of each.
std::vector<std::string> secret_reads(GroundState& s, const std::vector<Phase>& phases) {
    std::vector<std::string> found;
    for (const std::size_t k : serial_order(predecessors(phases))) {
        Snapshot before(s);
        phases[k].run();
        auto right = fingerprints(s);
        for (const Data data : {Data::points, Data::increments, Data::stress, Data::grid, Data::bodies,
                                Data::contact, Data::energy}) {
            if (names(phases[k], data)) continue;
            before.restore(s);
            spoil(s, data);
            phases[k].run();
            auto spoilt = fingerprints(s);
            spoilt[static_cast<std::size_t>(data)] = right[static_cast<std::size_t>(data)];
            if (spoilt != right) found.push_back(phases[k].name + ": " + stress::name_of(data));
        }
        before.restore(s);
        phases[k].run();
    }
    return found;
}

TEST_P(RealPhases, ReadOnlyWhatTheySayTheyRead) {
    const auto pull = moving(GetParam());
    std::vector<Phase> phases = step_phases(pull->state());
    for (int step = 0; step < kSteps; ++step) run_checked(phases, pull->state());
    EXPECT_EQ(secret_reads(pull->state(), phases), std::vector<std::string>{});
    std::erase(phases[0].reads, Version{Data::stress, 0});
    EXPECT_EQ(secret_reads(pull->state(), phases), std::vector<std::string>{"points to grid: stress"});
}

INSTANTIATE_TEST_SUITE_P(Laws, RealPhases,
                         testing::Values(&support::small_pull, &support::small_screening_pull),
                         [](const auto& info) { return info.index == 0 ? "full" : "screening"; });

}  // namespace
}  // namespace sandgraph::graph
