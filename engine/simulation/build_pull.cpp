#include "simulation/build_pull.hpp"

#include <fmt/format.h>

#include <cmath>
#include <limits>

#include "base/error.hpp"
#include "mpm/layout.hpp"
#include "mpm/time_step.hpp"
#include "packings/rve_options.hpp"
#include "simulation/build_screening.hpp"
#include "stress/elastic.hpp"
#include "stress/mohr_coulomb.hpp"

namespace sandgraph::simulation {
namespace {

constexpr double kHeave = 1.0;  // room above the ground beyond the pull itself [m]

bool horizontal(const scene::Scene& s) { return s.anchor.orientation == scene::Orientation::horizontal; }

mpm::RigidPlate plate_of(const scene::Scene& scene) {
    const scene::Anchor& a = scene.anchor;
    const double surface = scene.domain.depth, H = embedment(a);
    mpm::RigidPlate plate;
    plate.x = a.position;
    plate.y = horizontal(scene) ? surface - H - 0.5 * a.thickness : surface - H + 0.5 * a.width;
    plate.half_width = 0.5 * (horizontal(scene) ? a.width : a.thickness);
    plate.half_height = 0.5 * (horizontal(scene) ? a.thickness : a.width);
    plate.friction_angle = a.friction_angle;
    return plate;
}

// K0 = 1: the pressure at the plate's centre, linear with depth.
mpm::RestPressure rest_pressure(const scene::Scene& scene, const packings::PreparedGround& ground,
                                const mpm::RigidPlate& p) {
    const double gamma = ground.density * scene.ground.gravity;
    const double pressure = scene.ground.surcharge + gamma * (scene.domain.depth - p.y);
    return {pressure, pressure, gamma, gamma};
}

mpm::Points lay_out(const scene::Scene& scene, const packings::PreparedGround& ground) {
    mpm::Layout layout;
    layout.ground = {0, 0, scene.domain.width, scene.domain.depth};
    layout.cell = scene.domain.cell;
    layout.points_per_cell = scene.domain.points_per_cell;
    layout.density = ground.density;
    if (scene.anchor.present) layout.cavities = {plate_of(scene).rectangle()};
    return mpm::lay_out(layout);
}

mpm::GridShape grid_shape(const scene::Scene& scene) {
    const double lift = scene.anchor.present ? scene.anchor.pull_to * scene.anchor.width : 0,
                 cell = scene.domain.cell;
    return {0, 0, cell, static_cast<int>(std::lround(scene.domain.width / cell)),
            static_cast<int>(std::ceil((scene.domain.depth + lift + kHeave) / cell))};
}

std::unique_ptr<stress::Law> law_of(const scene::Scene& scene, const packings::PreparedGround& ground,
                                    const mpm::Points& points) {
    const scene::Ground& g = scene.ground;
    if (g.law == scene::Law::rve) {
        const std::vector<double>& radii = ground.rows.front().packing->grains->radius;
        graph::RveLawSetup setup{g.grains.material, packings::rve_options(g.rve, g.grains.material, radii),
                                 ground.rows, points.row, g.rve};
        if (scene.mode == scene::Mode::screening) return screening_law(scene, ground, std::move(setup));
        return std::make_unique<graph::RveLaw>(std::move(setup));
    }
    std::vector<Stress> initial;
    std::vector<double> out_of_plane;
    for (const std::int32_t row : points.row) {
        const double s = -ground.row_pressure[static_cast<std::size_t>(row)];
        initial.push_back({s, s, 0});
        out_of_plane.push_back(s);
    }
    const stress::ElasticConstants elastic{g.continuum.young, g.continuum.poisson};
    if (g.law == scene::Law::elastic) return std::make_unique<stress::Elastic>(elastic, std::move(initial));
    const stress::MohrCoulombConstants strength{g.continuum.young, g.continuum.poisson,
                                                g.continuum.friction_angle, g.continuum.dilation_angle,
                                                g.continuum.cohesion};
    return std::make_unique<stress::MohrCoulomb>(strength, std::move(initial), std::move(out_of_plane));
}

graph::StepSettings settings_of(const scene::Scene& scene, const packings::PreparedGround& ground,
                                double modulus) {
    graph::StepSettings s;
    s.dt = mpm::time_step(scene.mpm, {scene.domain.cell, modulus, ground.density});
    s.scheme = scene.mpm;
    s.gravity = scene.ground.gravity;
    s.surcharge = scene.ground.surcharge;
    s.boundaries = {mpm::Side::mirror, mpm::Side::mirror, mpm::Side::fixed, mpm::Side::free};
    return s;
}

// Faster than that, contacts come and go between two looks at them.
void require_slow_plate(const scene::Scene& scene, double dt) {
    constexpr double most = 0.01;  // cells a step; the paper's rate takes 1e-4
    const double cells = scene.anchor.pull_rate * dt / scene.domain.cell;
    if (cells > most)
        throw InputError(scene.where("anchor.pull_rate"),
                         fmt::format("anchor.pull_rate = {:g} m/s", scene.anchor.pull_rate),
                         fmt::format("the plate would move {:.2g} cells in one step of {:.2g} s", cells, dt),
                         fmt::format("pull with {:.2g} m/s at most", most * scene.domain.cell / dt));
}

void add_plate(const scene::Scene& scene, const packings::PreparedGround& ground, graph::GroundState& state) {
    state.has_plate = true;
    state.plate = plate_of(scene);
    state.plate.stiffness =
        mpm::contact_stiffness(scene.mpm.contact_stiffness, state.law->p_wave_modulus(), scene.domain.cell);
    state.plate.rest = rest_pressure(scene, ground, state.plate);
}

graph::PullPlan plan_of(const scene::Scene& scene) {
    graph::PullPlan plan;
    plan.direction = horizontal(scene) ? Vec2(0, 1) : Vec2(1, 0);
    plan.width = scene.anchor.width;
    plan.rate = scene.anchor.pull_rate;
    plan.ramp = scene.anchor.ramp;
    return plan;
}

}  // namespace

double embedment(const scene::Anchor& anchor) { return anchor.embedment_ratio * anchor.width; }

double unit_load(const scene::Scene& scene, const packings::PreparedGround& ground) {
    const double gamma = ground.density * scene.ground.gravity;
    return scene.anchor.width * (gamma * embedment(scene.anchor) + scene.ground.surcharge);
}

double equivalent_embedment(const scene::Scene& scene, const packings::PreparedGround& ground) {
    if (scene.ground.gravity == 0) return std::numeric_limits<double>::quiet_NaN();
    return unit_load(scene, ground) / (ground.density * scene.ground.gravity * scene.anchor.width);
}

double whole_plate_factor(const scene::Scene& scene) { return horizontal(scene) ? 2 : 1; }

std::unique_ptr<graph::Pull> build_pull(const scene::Scene& scene, const packings::PreparedGround& ground) {
    mpm::Points points = lay_out(scene, ground);
    auto law = law_of(scene, ground, points);
    auto state = std::make_unique<graph::GroundState>(settings_of(scene, ground, law->p_wave_modulus()),
                                                      std::move(points), grid_shape(scene));
    state->law = std::move(law);
    state->law->initialise(state->batch());
    if (scene.anchor.present) {
        require_slow_plate(scene, state->settings.dt);
        add_plate(scene, ground, *state);
    }
    return std::make_unique<graph::Pull>(std::move(state), plan_of(scene));
}

}  // namespace sandgraph::simulation
