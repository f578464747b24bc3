#include "results/run_summary.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "base/hash.hpp"
#include "base/revision.hpp"
#include "results/analytic.hpp"
#include "results/drag.hpp"
#include "results/exact.hpp"
#include "results/finished_run.hpp"
#include "results/known_sand.hpp"
#include "results/load_error.hpp"
#include "results/mesh_error.hpp"
#include "results/peak.hpp"
#include "results/screening_summary.hpp"
#include "scene/scene_hash.hpp"
#include "simulation/caveats.hpp"
#include "simulation/scene_spec.hpp"

namespace sandgraph::results {
namespace {

constexpr double kDegrees = 180 / std::numbers::pi;
constexpr double kSlow = 0.02;        // wave pressure over a body's load
constexpr double kQuasiStatic = 0.1;  // kinetic energy over the plate's work
constexpr double kDragSeen = 0.02;    // of the load; past it a warning,
constexpr double kDragMost = 0.1;     // past it no breakout

struct Curve {
    std::vector<double> d, load;
};

Curve curve_of(const io::RunRecord& record) {
    Curve c;
    for (const io::LoadRow& row : record.load) c.d.push_back(row.d_over_B), c.load.push_back(row.load);
    return c;
}

// The formula for the scene's plate, textbook's form.
double formula_at(const scene::Scene& scene, double ratio, double friction_angle) {
    return pulled_up(scene) ? meyerhof_adams(ratio, friction_angle) : biarez(ratio, friction_angle);
}

bool is_rough(const scene::Scene& scene, double friction_angle) {
    return scene.anchor.friction_angle >= friction_angle;
}

void add_formula(const scene::Scene& scene, const packings::PreparedGround& ground, io::Summary& s) {
    const packings::FrictionSample& phi = ground.friction;
    if (phi.mean <= 0) return;
    const double ratio = simulation::equivalent_embedment(scene, ground) / scene.anchor.width;
    s.n_gamma_meyerhof_adams = meyerhof_adams(ratio, phi.mean);
    s.n_gamma_biarez = biarez(ratio, phi.mean);
    if (pulled_up(scene) && is_rough(scene, phi.mean))
        s.extra.emplace_back(
            "n_gamma_meyerhof_adams_thick",
            meyerhof_adams_thick(ratio, scene.anchor.thickness / scene.anchor.width, phi.mean));
    s.extra.emplace_back("n_gamma_formula_ci95", 0.5 * (formula_at(scene, ratio, phi.mean + phi.ci95) -
                                                        formula_at(scene, ratio, phi.mean - phi.ci95)));
    s.extra.emplace_back("equivalent_embedment_ratio", ratio);
    s.extra.emplace_back("friction_angle_deg", phi.mean * kDegrees);
    s.extra.emplace_back("friction_angle_ci95_deg", phi.ci95 * kDegrees);
    s.extra.emplace_back("friction_packings", phi.packings);
    s.extra.emplace_back("friction_angle_packing_deg", ground.friction_angle * kDegrees);
}

// Inertia carries a share of the load that nobody can tell from the sand's.
bool is_quasi_static(const io::Summary& s) {
    return !(s.kinetic_to_strain_energy_max > kQuasiStatic) &&
           !(s.number("rate_pressure_ratio") > simulation::forbidding_rate) &&
           !(s.number("drag_share") > kDragMost);
}

// What to change: the setting that carries most, where it is above its default, else the rate.
const char* remedy(const Drag& drag, const scene::Scene& scene) {
    const mpm::Scheme &scheme = scene.mpm, usual;
    const double most = std::max({drag.damping, drag.pic, drag.inertia});
    if (drag.damping == most && scheme.damping > usual.damping) return "mpm.damping";
    if (drag.pic == most && scheme.pic_fraction > usual.pic_fraction) return "mpm.pic_fraction";
    return scene.anchor.present ? "anchor.pull_rate" : "the body's velocity";
}

void add_drag(std::span<const io::LoadRow> rows, double at, const scene::Scene& scene, io::Summary& s) {
    const Drag drag = drag_at(rows, at);
    const double sum = drag.sum(), most = std::max(sum, largest_drag(rows));
    s.extra.emplace_back("drag_share", sum);
    s.extra.emplace_back("damping_share", drag.damping);
    s.extra.emplace_back("pic_share", drag.pic);
    s.extra.emplace_back("inertia_share", drag.inertia);
    s.extra.emplace_back("drag_share_max", most);
    if (most > kDragSeen)
        s.warnings.push_back(fmt::format(
            "damping, PIC and inertia carry {:.1f} % of the load where it is told ({:.1f}, {:.1f} and "
            "{:.1f} %) and {:.1f} % at most: it is about that much too high; lower {}",
            100 * sum, 100 * drag.damping, 100 * drag.pic, 100 * drag.inertia, 100 * most,
            remedy(drag, scene)));
}

void add_breakout(const simulation::RunSession& session, const scene::Scene& scene,
                  const packings::PreparedGround& ground, io::Summary& s) {
    const Curve curve = curve_of(session.recorders().record());
    const Breakout breakout = results::breakout(curve.d, curve.load);
    add_drag(session.recorders().record().load, breakout.d_over_B, scene, s);
    s.breakout = breakout.kind != BreakoutKind::still_rising && is_quasi_static(s);
    s.breakout_load = breakout.load, s.breakout_d_over_B = breakout.d_over_B;
    // docs/how_it_works.md (eq. 42).
    if (s.breakout) s.n_gamma = breakout.load / simulation::unit_load(scene, ground);
    s.late_load = late_load(curve.d, curve.load);
    if (session.recorders().record().load_audited)
        add_load_error(session.recorders().record().load, breakout, s.audit);
    s.extra.emplace_back("breakout_criterion", static_cast<double>(breakout.kind));
    if (const auto later = higher_later(curve.d, curve.load, breakout)) {
        s.extra.emplace_back("later_load_N_per_m", later->load);
        s.extra.emplace_back("later_d_over_B", later->d_over_B);
    }
}

void warn_of_inertia(io::Summary& s) {
    if (s.kinetic_to_strain_energy_max > kQuasiStatic)
        s.warnings.push_back(
            fmt::format("kinetic energy reached {:.2g} of the plate's work: too fast to be quasi-static (10 "
                        "% is the usual limit); "
                        "lower anchor.pull_rate",
                        s.kinetic_to_strain_energy_max));
}

void add_exact(const Curve& curve, const scene::Scene& scene, const packings::PreparedGround& ground,
               io::Summary& s) {
    const auto exact = exact_load(scene, ground.density);
    if (!exact) return;
    // Of a wall that gives way the ground drives the body.
    const double limit = std::fabs(limit_load(curve.d, curve.load)) / exact->unit;
    s.extra.emplace_back("limit_factor", limit);
    s.extra.emplace_back("exact_factor", exact->factor);
    s.extra.emplace_back("limit_error", limit / exact->factor - 1);
}

void add_mesh(const scene::Scene& scene, const packings::PreparedGround& ground, io::Summary& s) {
    s.extra.emplace_back("cells_per_width", cells_per_width(scene));
    s.extra.emplace_back("mesh_error", book_mesh_error(scene, ground.friction.mean));
}

// The load of a body beside an anchor's formulas: no breakout, no N.
void add_body_load(const simulation::RunSession& session, const scene::Scene& scene,
                   const packings::PreparedGround& ground, io::Summary& s) {
    const Curve curve = curve_of(session.recorders().record());
    s.kinetic_to_strain_energy_max = session.recorders().loads().kinetic_share_max();
    for (std::size_t k = 0; k < curve.load.size(); ++k)
        if (k == 0 || curve.load[k] > s.breakout_load)
            s.breakout_load = curve.load[k], s.breakout_d_over_B = curve.d[k];
    s.late_load = late_load(curve.d, curve.load);
    if (session.recorders().record().load_audited)
        add_load_error(session.recorders().record().load,
                       {BreakoutKind::still_rising, s.breakout_d_over_B, s.breakout_load}, s.audit);
    s.warnings = simulation::caveats(scene, ground, session.simulation());
    warn_of_inertia(s);
    const double wave = simulation::wave_load(scene, ground, session.simulation()) / std::fabs(s.late_load);
    s.extra.emplace_back("wave_load_share", wave);
    if (wave > kSlow)
        s.warnings.push_back(fmt::format(
            "the body is fast: the wave pressure rho c v is {:.2g} of its late load, and inertia may "
            "carry as much of it; take a smaller velocity",
            wave));
    add_drag(session.recorders().record().load, s.breakout_d_over_B, scene, s);
    add_exact(curve, scene, ground, s);
}

void add_loads(const simulation::RunSession& session, const scene::Scene& scene,
               const packings::PreparedGround& ground, io::Summary& s) {
    s.kinetic_to_strain_energy_max = session.recorders().loads().kinetic_share_max();
    s.extra.emplace_back("pull_rate_m_per_s", scene.anchor.pull_rate);
    s.extra.emplace_back("rate_pressure_ratio", simulation::rate_share(scene, ground, session.simulation()));
    s.warnings = simulation::caveats(scene, ground, session.simulation());
    warn_of_inertia(s);
    add_breakout(session, scene, ground, s);
    add_formula(scene, ground, s);
    add_exact(curve_of(session.recorders().record()), scene, ground, s);
    s.extra.emplace_back("unit_load_N_per_m", simulation::unit_load(scene, ground));
}

void add_grains(const simulation::Simulation& run, io::Summary& s) {
    const stress::Law& law = *run.state().law;
    const stress::GrainUse grains = law.grain_use();
    s.dem_steps = grains.dem_steps, s.rve_updates = grains.updates;
    if (law.screening_log()) return add_screening(law, run.state().points.size(), s);
    if (law.answers() == stress::Answers::grains) s.dem_fraction_final = s.dem_fraction_mean = 1;
    for (const auto& [name, value] : law.figures()) s.extra.emplace_back(name, value);
}

void add_known_sand(const scene::Scene& scene, const packings::PreparedGround& ground, io::Summary& s) {
    if (!ground.surrogate) return;
    const KnownSand sand = known_sand(ground);
    s.surrogate_knows_this_sand = sand.known;
    if (!sand.known && !scene.screening.gate.active) s.warnings.push_back(unknown_sand_text(sand, ground));
}

void add_history(const simulation::RunSession& session, io::Summary& s) {
    if (!session.recorders().history()) return;
    s.extra.emplace_back("history_rows", static_cast<double>(session.recorders().history()->rows()));
    s.extra.emplace_back("history_full", session.recorders().history()->full());
}

}  // namespace

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
    if (scene.anchor.present)
        add_loads(session, scene, ground, s);
    else if (scene.loaded())
        add_body_load(session, scene, ground, s);
    if (scene.loaded()) add_mesh(scene, ground, s);
    add_known_sand(scene, ground, s);
    s.extra.emplace_back("density_kg_per_m3", ground.density);
    for (const auto& [phase, seconds] : session.recorders().record().timing)
        s.extra.emplace_back("seconds " + phase, seconds);
    return s;
}

namespace {

std::string breakout_text(const io::Summary& s) {
    const std::string place =
        fmt::format("at d/B {:.3f}  ({:.1f} kN/m)\n", s.breakout_d_over_B, s.breakout_load / 1000);
    if (s.breakout) {
        const bool steady = s.number("breakout_criterion") == static_cast<double>(BreakoutKind::steady_slope);
        return fmt::format("{}  N_gamma {:.2f} {}",
                           steady ? "breakout, where the load begins to rise steadily:" : "breakout",
                           s.n_gamma, place);
    }
    return fmt::format(
        "no breakout {}: largest load so far {:.2f} gamma H B {}",
        is_quasi_static(s) ? "yet, the load still rises" : "is claimed, the plate is too fast or dragged",
        s.breakout_load / s.number("unit_load_N_per_m"), place);
}

std::string later_text(const io::Summary& s) {
    const double later = s.number("later_load_N_per_m");
    if (std::isnan(later)) return "";
    return fmt::format("the load is higher later: {:.1f} kN/m at d/B {:.3f}\n", later / 1000,
                       s.number("later_d_over_B"));
}

std::string angle_text(const io::Summary& s) {
    const double phi = s.number("friction_angle_deg"), packings = s.number("friction_packings");
    if (packings == 0) return fmt::format("phi = {:.1f} deg of the scene", phi);
    if (packings == 1)
        return fmt::format("phi = {:.1f} deg of one packing; others of its sand differ by 2 to 6 deg", phi);
    return fmt::format("phi = {:.1f} +- {:.1f} deg, mean of {:.0f} packings", phi,
                       s.number("friction_angle_ci95_deg"), packings);
}

std::string formula_text(const io::Summary& s, bool up) {
    const double formula = up ? s.n_gamma_meyerhof_adams : s.n_gamma_biarez;
    if (!std::isfinite(formula)) return "";
    const double interval = s.number("n_gamma_formula_ci95"),
                 thick = s.number("n_gamma_meyerhof_adams_thick");
    std::string out = fmt::format("formula   N_gamma {:.2f}{}  ({}, {})\n", formula,
                                  interval > 0 ? fmt::format(" +- {:.2f}", interval) : "",
                                  up ? "Meyerhof & Adams 1968" : "Biarez 1965", angle_text(s));
    if (std::isfinite(thick))
        out += fmt::format(
            "          N_gamma {:.2f}  for this plate: thick and rough, it drags the sand beside its ends\n",
            thick);
    return out;
}

std::string energy_text(double share) {
    // Stopped before it was looked at, or the ground has worked on the plate all the time.
    return std::isnan(share) ? "kinetic energy over the plate's work: -"
                             : fmt::format("kinetic energy at most {:.2g} of the plate's work", share);
}

std::string loads_text(const io::Summary& s, bool up) {
    return breakout_text(s) + later_text(s) + formula_text(s, up) +
           fmt::format("late load {:.1f} kN/m, {}\n", s.late_load / 1000,
                       energy_text(s.kinetic_to_strain_energy_max));
}

}  // namespace

std::string exact_text(const io::Summary& s) {
    const double limit = s.number("limit_factor"), exact = s.number("exact_factor");
    if (std::isnan(limit)) return "";
    if (std::isnan(exact)) return fmt::format("limit factor {:.4g}, no exact one is known\n", limit);
    return fmt::format("limit factor {:.4g}, exactly {:.4g}: {:+.1f} %\n", limit, exact,
                       100 * s.number("limit_error"));
}

std::string mesh_text(const io::Summary& s) {
    const double error = s.number("mesh_error"), cells = s.number("cells_per_width");
    if (std::isnan(cells)) return "";
    if (std::isnan(error))
        return fmt::format("{:.3g} cells a width; what they make of the load is not known\n", cells);
    return fmt::format("{:.3g} cells a width: the load some {:+.1f} % off by cases with an exact one\n",
                       cells, 100 * error);
}

std::string summary_text(const io::Summary& s, const scene::Scene& scene) {
    std::string out;
    if (scene.anchor.present) out += loads_text(s, pulled_up(scene));
    if (scene.loaded() && !scene.anchor.present)
        out += fmt::format("largest load {:.4g} kN/m at d/B {:.3f}, late load {:.4g} kN/m, {}\n",
                           s.breakout_load / 1000, s.breakout_d_over_B, s.late_load / 1000,
                           energy_text(s.kinetic_to_strain_energy_max));
    out += mesh_text(s) + exact_text(s);
    for (const std::string& warning : s.warnings) out += "warning: " + warning + "\n";
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
