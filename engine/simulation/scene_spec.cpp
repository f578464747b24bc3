#include "simulation/scene_spec.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "base/error.hpp"
#include "mpm/time_step.hpp"
#include "packings/samples.hpp"
#include "scene/alignment.hpp"
#include "simulation/build_screening.hpp"
#include "simulation/estimate.hpp"
#include "stress/elastic.hpp"
#include "stress/mohr_coulomb.hpp"

namespace sandgraph::simulation {
namespace {

// Room above the ground beyond the pull itself [m]: a plate width; of a ground without one a fifth of its
// depth.
double heave(const scene::Scene& s) { return s.loaded() ? s.anchor.width : 0.2 * s.domain.depth; }

// How high bodies stand or rise.
double highest(const scene::Scene& s) {
    double y = s.domain.depth;
    for (const scene::Body& body : s.bodies)
        y = std::max(y, body.high(1) + (body.velocity[1] > 0 ? body.travel : 0));
    return y;
}

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

mpm::GridShape grid_shape(const scene::Scene& scene) {
    const double lift = scene.anchor.present ? scene.anchor.pull_to * scene.anchor.width : 0,
                 cell = scene.domain.cell;
    const auto across = static_cast<int>(std::lround(scene.domain.width / cell)),
               up = static_cast<int>(std::ceil((highest(scene) + lift + heave(scene)) / cell));
    const double dx = scene::shifts_x(scene) ? 0.5 * cell : 0, dy = scene::shifts_y(scene) ? 0.5 * cell : 0;
    return {-dx, -dy, cell, across + (dx > 0 ? 1 : 0), up + (dy > 0 ? 1 : 0)};
}

std::unique_ptr<stress::Law> granular_law(const scene::Scene& scene, const packings::PreparedGround& ground,
                                          const mpm::Points& points, const graph::PoolMaker& make_pool) {
    const scene::Ground& g = scene.ground;
    graph::RveLawSetup setup{g.grains.material,
                             dem::rve_options(g.rve, g.grains.material, ground.radii()),
                             ground.packings,
                             packings::deal(points.row, g.grains),
                             g.rve,
                             make_pool};
    if (scene.mode == scene::Mode::screening) return screening_law(scene, ground, std::move(setup));
    return std::make_unique<graph::RveLaw>(std::move(setup));
}

std::unique_ptr<stress::Law> closed_form_law(const scene::Scene& scene,
                                             const packings::PreparedGround& ground,
                                             const mpm::Points& points) {
    const scene::Ground& g = scene.ground;
    std::vector<Stress> initial;
    std::vector<double> out_of_plane;  // a horizontal stress, as that along x
    for (const std::int32_t row : points.row) {
        const double s = -ground.row_pressure[static_cast<std::size_t>(row)];
        initial.push_back({g.k0 * s, s, 0});
        out_of_plane.push_back(g.k0 * s);
    }
    if (g.law == scene::Law::elastic)
        return std::make_unique<stress::Elastic>(g.continuum.elastic(), std::move(initial));
    return std::make_unique<stress::MohrCoulomb>(g.continuum, std::move(initial), std::move(out_of_plane));
}

LawFactory law_of(const scene::Scene& scene, const packings::PreparedGround& ground,
                  const graph::PoolMaker& make_pool) {
    if (scene.ground.law != scene::Law::rve)
        return [scene, ground](const mpm::Points& points) { return closed_form_law(scene, ground, points); };
    return [scene, ground, make_pool](const mpm::Points& points) {
        return granular_law(scene, ground, points, make_pool);
    };
}

GroundSpec ground_of(const scene::Scene& scene, const packings::PreparedGround& ground) {
    GroundSpec out;
    out.extent = {0, 0, scene.domain.width, scene.domain.depth};
    out.points_per_cell = scene.domain.points_per_cell;
    out.density = ground.density;
    out.columns_on_sides = scene::columns_on_sides(scene);
    return out;
}

mpm::RestPressure rest_on(const scene::Scene& scene, const packings::PreparedGround& ground,
                          const mpm::RigidPlate& plate) {
    return mpm::rest_pressure(scene.ground.surcharge, ground.density * scene.ground.gravity,
                              scene.domain.depth - plate.y, scene.ground.k0);
}

// Pulled along its normal.
BodySpec anchor_of(const scene::Scene& scene, const packings::PreparedGround& ground) {
    const scene::Anchor& a = scene.anchor;
    BodySpec body{plate_of(scene), {}};
    body.plate.rest = rest_on(scene, ground, body.plate);
    body.programme.direction = horizontal(scene) ? Vec2(0, 1) : Vec2(1, 0);
    body.programme.rate = a.pull_rate;
    body.programme.ramp = a.ramp * a.width;
    body.programme.settle = settling_time(a.width);
    return body;
}

// Of the scene, along x or y.
BodySpec body_of(const scene::Scene& scene, const packings::PreparedGround& ground, const scene::Body& b) {
    BodySpec body;
    body.plate.x = b.centre[0], body.plate.y = b.centre[1];
    body.plate.half_width = 0.5 * b.size[0], body.plate.half_height = 0.5 * b.size[1];
    body.plate.round = b.shape == scene::Shape::circle;
    body.plate.friction_angle = b.friction_angle;
    body.plate.rest = rest_on(scene, ground, body.plate);
    if (!b.moves()) return body;
    const Vec2 v(b.velocity[0], b.velocity[1]);
    body.programme.direction = v.normalized();
    body.programme.rate = v.norm();
    body.programme.ramp = b.ramp * b.travel;
    if (&b != scene.loaded_body()) body.programme.travel = b.travel;  // the loaded one ends the run
    body.programme.settle = settling_time(b.width());
    return body;
}

// The loaded one first.
std::vector<BodySpec> bodies_of(const scene::Scene& scene, const packings::PreparedGround& ground) {
    std::vector<BodySpec> out;
    const scene::Body* loaded = scene.loaded_body();
    if (scene.anchor.present) out.push_back(anchor_of(scene, ground));
    if (loaded) out.push_back(body_of(scene, ground, *loaded));
    for (const scene::Body& body : scene.bodies)
        if (&body != loaded) out.push_back(body_of(scene, ground, body));
    return out;
}

// At rest only the row beside a face touches it: the face stands out by p0/k_a, which must not reach far into
// that row, nor must what a pull adds.
void require_stiff_contact(const scene::Scene& scene, const Simulation& simulation) {
    constexpr double most = 0.2;  // of the distance of two rows
    for (const graph::Body& body : simulation.state().bodies) {
        const mpm::RestPressure& r = body.plate.rest;
        const double deep = body.plate.half_height;
        const double pressure =
            std::max(r.vertical + deep * r.vertical_gradient, r.horizontal + deep * r.horizontal_gradient);
        const double out = pressure / body.plate.stiffness / (most * scene::point_spacing(scene.domain));
        if (out > 1)
            throw InputError(
                scene.where("mpm.contact_stiffness"),
                fmt::format("mpm.contact_stiffness = {:g}", scene.mpm.contact_stiffness),
                fmt::format("the {:.3g} kPa at rest would press several rows of points into the plate",
                            pressure / 1000),
                fmt::format("write {:.2g} or more with this cell", 1.01 * out * scene.mpm.contact_stiffness));
    }
}

// Nothing in a liquid resists a change of shape, and FLIP keeps what the grid does not see of it: at rest it
// began to slosh, and to 0.05 m in 37,000 steps with a tenth of PIC; half of it takes that.
bool is_liquid(const scene::Scene& s) {
    const auto& c = s.ground.continuum;
    return s.ground.law == scene::Law::mohr_coulomb && c.friction_angle == 0 && c.cohesion == 0;
}

mpm::Scheme scheme_of(const scene::Scene& scene) {
    constexpr double calming = 0.5;
    mpm::Scheme scheme = scene.mpm;
    if (is_liquid(scene)) scheme.pic_fraction = std::max(scheme.pic_fraction, calming);
    return scheme;
}

}  // namespace

double embedment(const scene::Anchor& anchor) { return anchor.embedment_ratio * anchor.width; }

double unit_load(const scene::Scene& scene, const packings::PreparedGround& ground) {
    const double gamma = ground.density * scene.ground.gravity;
    const double deep = scene.anchor.present ? embedment(scene.anchor) : scene.anchor.width;
    return scene.anchor.width * (gamma * deep + scene.ground.surcharge);
}

double equivalent_embedment(const scene::Scene& scene, const packings::PreparedGround& ground) {
    if (scene.ground.gravity == 0) return std::numeric_limits<double>::quiet_NaN();
    return unit_load(scene, ground) / (ground.density * scene.ground.gravity * scene.anchor.width);
}

double whole_plate_factor(const scene::Scene& scene) {
    const scene::Body* body = scene.loaded_body();
    return (body ? body->low(0) < 0 : horizontal(scene)) ? 2 : 1;
}

std::unique_ptr<Simulation> simulation_of(const scene::Scene& scene, const packings::PreparedGround& ground,
                                          const graph::PoolMaker& make_pool) {
    auto simulation = std::make_unique<Simulation>(spec_of(scene, ground, make_pool));
    if (scene.loaded()) require_slow_plate(scene, simulation->state().settings.dt);
    require_stiff_contact(scene, *simulation);
    return simulation;
}

double end_mark(const scene::Scene& scene) {
    return scene.loaded() ? scene.anchor.pull_to : scene.mpm.end_time;
}

Spec spec_of(const scene::Scene& scene, const packings::PreparedGround& ground,
             const graph::PoolMaker& make_pool) {
    Spec spec;
    spec.ground = ground_of(scene, ground);
    spec.grid = grid_shape(scene);
    spec.boundaries.between_x = scene::shifts_x(scene), spec.boundaries.between_y = scene::shifts_y(scene);
    spec.gravity = Vec2(0, -scene.ground.gravity);
    spec.surcharge = scene.ground.surcharge;
    spec.internal_length = scene.ground.internal_length;
    spec.scheme = scheme_of(scene);
    spec.bodies = bodies_of(scene, ground);
    for (BodySpec& body : spec.bodies) body.plate.trimmed = scene.domain.edges == scene::Edges::between_nodes;
    spec.loaded = scene.loaded();
    spec.width = scene.anchor.width;
    spec.law = law_of(scene, ground, make_pool);
    return spec;
}

}  // namespace sandgraph::simulation
