#include "results/run_summary.hpp"

#include <fmt/format.h>

#include <cmath>
#include <numbers>

#include "base/hash.hpp"
#include "base/revision.hpp"
#include "results/analytic.hpp"
#include "results/known_sand.hpp"
#include "results/peak.hpp"
#include "results/screening_summary.hpp"
#include "scene/scene_hash.hpp"
#include "simulation/scene_spec.hpp"

namespace sandgraph::results {
namespace {

constexpr double kDegrees = 180 / std::numbers::pi;
constexpr double kQuasiStatic = 0.1;  // kinetic energy over the plate's work

struct Curve {
    std::vector<double> d, load;
};

Curve curve_of(const io::RunRecord& record) {
    Curve c;
    for (const io::LoadRow& row : record.load) c.d.push_back(row.d_over_B), c.load.push_back(row.load);
    return c;
}

void add_loads(const simulation::RunSession& session, const scene::Scene& scene,
               const packings::PreparedGround& ground, io::Summary& s) {
    const Curve curve = curve_of(session.recorders().record());
    const Breakout breakout = results::breakout(curve.d, curve.load);
    s.breakout_load = breakout.load, s.breakout_d_over_B = breakout.d_over_B;
    s.n_gamma = breakout.load / simulation::unit_load(scene, ground);
    s.late_load = late_load(curve.d, curve.load);
    s.extra.emplace_back("breakout_criterion", static_cast<double>(breakout.kind));
    if (ground.friction_angle <= 0) return;
    const double ratio = simulation::equivalent_embedment(scene, ground) / scene.anchor.width;
    s.n_gamma_meyerhof_adams = meyerhof_adams(ratio, ground.friction_angle);
    s.n_gamma_biarez = biarez(ratio, ground.friction_angle);
    s.extra.emplace_back("equivalent_embedment_ratio", ratio);
    s.extra.emplace_back("friction_angle_deg", ground.friction_angle * kDegrees);
}

void add_grains(const simulation::Simulation& run, io::Summary& s) {
    const stress::Law& law = *run.state().law;
    const stress::GrainUse grains = law.grain_use();
    s.dem_steps = grains.dem_steps, s.rve_updates = grains.updates;
    if (law.screening_log()) return add_screening(law, run.state().points.size(), s);
    if (law.answers() == stress::Answers::grains) s.dem_fraction_final = s.dem_fraction_mean = 1;
    for (const auto& [name, value] : law.figures()) s.extra.emplace_back(name, value);
}

void add_history(const simulation::RunSession& session, io::Summary& s) {
    if (!session.recorders().history()) return;
    s.extra.emplace_back("history_rows", static_cast<double>(session.recorders().history()->rows()));
    s.extra.emplace_back("history_full", session.recorders().history()->full());
}

}  // namespace

bool broke_out(const io::Summary& s) {
    const double kind = s.number("breakout_criterion");  // NaN without a plate
    return std::isfinite(kind) && kind != static_cast<double>(BreakoutKind::still_rising);
}

io::Summary summarise(const simulation::RunSession& session, const scene::Scene& scene,
                      const packings::PreparedGround& ground, int threads) {
    const simulation::Simulation& run = session.simulation();
    io::Summary s;
    s.points = static_cast<std::int64_t>(run.state().points.size()), s.steps = run.steps();
    s.wall_s = session.wall_seconds(), s.cpu_s = session.cpu_seconds();
    s.threads = threads, s.mode = session.recorders().record().info.mode, s.git = revision();
    s.scene_hash = hex(scene::scene_hash(scene));
    add_grains(run, s);
    add_history(session, s);
    if (ground.surrogate) s.surrogate_knows_this_sand = known_sand(ground).known;
    if (scene.anchor.present) {
        add_loads(session, scene, ground, s);
        s.kinetic_to_strain_energy_max = session.recorders().loads().kinetic_share_max();
        s.extra.emplace_back("unit_load_N_per_m", simulation::unit_load(scene, ground));
    }
    s.extra.emplace_back("density_kg_per_m3", ground.density);
    for (const auto& [phase, seconds] : session.recorders().record().timing)
        s.extra.emplace_back("seconds " + phase, seconds);
    return s;
}

namespace {

const char* breakout_words(const io::Summary& s) {
    switch (static_cast<BreakoutKind>(s.number("breakout_criterion"))) {
        case BreakoutKind::zero_slope:
            return "breakout";
        case BreakoutKind::steady_slope:
            return "breakout, where the load begins to rise steadily:";
        default:
            return "no breakout yet, the load still rises: largest";
    }
}

std::string energy_text(double share) {
    // Stopped before it was looked at, or the ground has worked on the plate all the time.
    if (std::isnan(share)) return ", kinetic energy over the plate's work: - (no work yet)\n";
    const char* warning =
        share > kQuasiStatic
            ? "warning: too fast to be quasi-static (10 % is the usual limit); lower anchor.pull_rate\n"
            : "";
    return fmt::format(", kinetic energy at most {:.2g} of the plate's work\n{}", share, warning);
}

}  // namespace

std::string summary_text(const io::Summary& s, const scene::Scene& scene,
                         const packings::PreparedGround& ground) {
    std::string out;
    if (scene.anchor.present) {
        const bool up = scene.anchor.orientation == scene::Orientation::horizontal;
        out += fmt::format("{}  N_gamma {:.2f} at d/B {:.3f}  ({:.1f} kN/m)\n", breakout_words(s), s.n_gamma,
                           s.breakout_d_over_B, s.breakout_load / 1000);
        if (ground.friction_angle > 0 && std::isfinite(s.n_gamma_meyerhof_adams))
            out +=
                fmt::format("formula   N_gamma {:.2f}  ({}, phi = {:.1f} deg {})\n",
                            up ? s.n_gamma_meyerhof_adams : s.n_gamma_biarez,
                            up ? "Meyerhof & Adams 1968" : "Biarez 1965", ground.friction_angle * kDegrees,
                            scene.ground.law == scene::Law::rve ? "measured on the packing" : "of the scene");
        out += fmt::format("late load {:.1f} kN/m{}", s.late_load / 1000,
                           energy_text(s.kinetic_to_strain_energy_max));
    }
    if (s.surrogate_knows_this_sand == false && !scene.screening.gate.active)
        out += fmt::format("warning: {}\n", unknown_sand_text(known_sand(ground), ground));
    out += fmt::format("{} points, {} steps, {:.3g} DEM steps, {:.0f} s on {} thread{}\n", s.points, s.steps,
                       double(s.dem_steps), s.wall_s, s.threads, s.threads == 1 ? "" : "s");
    if (scene.mode == scene::Mode::screening) out += screening_text(s);
    if (const double rows = s.number("history_rows"); rows > 0)
        out += fmt::format(
            "history.h5 holds {:.0f} updates{}\n", rows,
            s.number("history_full") > 0 ? "; it was full before the end (output.history_max)" : "");
    if (const double failures = s.number("rve_failures"); failures > 0)
        out += fmt::format(
            "warning: {:.0f} DEM updates failed and kept their last stress; do not trust this run\n",
            failures);
    return out;
}

}  // namespace sandgraph::results
