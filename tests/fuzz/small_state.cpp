#include "fuzz/small_state.hpp"

#include "fuzz/samples.hpp"
#include "graph/screening/law.hpp"
#include "mpm/layout.hpp"
#include "tests/support/element_surrogate.hpp"
#include "tests/support/table1_options.hpp"

namespace sandgraph::fuzz {
namespace {

graph::RowPacking row_packing() {
    static const auto packing = dem::compact(two_grains(), dem::Material{}, 10e3 * Mat2::Identity());
    return {packing, {2e7, 1.4e7}};
}

graph::ScreeningSetup setup_of(const mpm::Points& points) {
    graph::ScreeningSetup setup;
    setup.grains = {{}, support::table1_options(), {points.size(), row_packing()}, points.row};
    setup.surrogate = std::make_shared<support::ElementSurrogate>();
    setup.traits.assign(points.size(), {10e3, 0.2, 2e7, 1.4e7, 3.5, 0, 0, 0.5});
    setup.gate.strain = 2e-4;
    setup.audit.share = 1, setup.audit.load_points = 1;
    return setup;
}

}  // namespace

std::unique_ptr<graph::GroundState> small_state() {
    mpm::Points points = mpm::lay_out({{0, 0, 0.1, 0.3}, 0.1, 1, 2000, {}});
    graph::ScreeningSetup setup = setup_of(points);
    graph::StepSettings settings;
    settings.dt = 1e-4;
    settings.scheme.pic_fraction = settings.scheme.damping = 0, settings.gravity = Vec2(0, -9.81);
    auto state =
        std::make_unique<graph::GroundState>(settings, std::move(points), mpm::GridShape{0, 0, 0.1, 1, 3});
    state->law = std::make_unique<graph::ScreeningLaw>(std::move(setup));
    state->law->initialise(state->batch());
    return state;
}

void shear(graph::GroundState& state) {
    for (std::size_t p = 0; p < state.points.size(); ++p)
        state.points.F_inc[p] << 1 + 1e-6 * static_cast<double>(p), 0, 0, 1 - 1e-6 * static_cast<double>(p);
    for (int step = 0; step < 120; ++step) state.law->update(state.batch());
}

}  // namespace sandgraph::fuzz
