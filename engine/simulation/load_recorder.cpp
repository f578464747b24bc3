#include "simulation/load_recorder.hpp"

#include <algorithm>
#include <cmath>

#include "mpm/audit.hpp"

namespace sandgraph::simulation {
namespace {

constexpr double kQuasiStaticFrom = 0.005;  // d/B; before it the plate has done no work to compare with

}  // namespace

void LoadRecorder::add(const Simulation& simulation) {
    const graph::GroundState& s = simulation.state();
    const graph::Body& anchor = s.bodies.front();
    d_ += simulation.d_over_B(), load_ += factor_ * simulation.load();
    leading_ += factor_ * simulation.leading(), trailing_ += factor_ * simulation.trailing();
    plate_work_ += factor_ * mpm::plate_work(anchor.plate, anchor.contact.reaction, s.settings.dt);
}

double LoadRecorder::work_scale(const Simulation& simulation) const {
    return std::fmax(plate_work_, unit_load_ * simulation.travel());
}

std::optional<io::LoadRow> LoadRecorder::after_step(const Simulation& simulation) {
    if (simulation.anchored()) add(simulation);
    steps_ += 1;
    if (!due_by(simulation.mark())) return std::nullopt;
    io::LoadRow out = row(simulation, load_ / steps_);
    add_error(simulation, out);
    add_drag(simulation, out);
    if (simulation.d_over_B() >= kQuasiStaticFrom && plate_work_ > 0)  // soft ground may push the plate first
        kinetic_share_max_ = std::fmax(kinetic_share_max_, out.kinetic_energy / work_scale(simulation));
    while (next_ <= simulation.mark()) next_ += every_;
    steps_ = d_ = load_ = leading_ = trailing_ = 0;
    last_ = out.load;
    return out;
}

io::LoadRow LoadRecorder::row(const Simulation& simulation, double load) const {
    const graph::GroundState& s = simulation.state();
    io::LoadRow out;
    out.d_over_B = d_ / steps_, out.load = load, out.time = simulation.time();
    out.leading = leading_ / steps_, out.trailing = trailing_ / steps_;
    out.kinetic_energy = factor_ * mpm::kinetic_energy(s.points, s.settings.scheme.mass_scaling);
    out.strain_work = factor_ * s.stress_work;
    out.plate_work = plate_work_;
    const stress::GrainUse grains = s.law->grain_use();
    out.rve_active = static_cast<double>(grains.active);
    out.dem_steps = static_cast<double>(grains.dem_steps);
    return out;
}

// docs/how_it_works.md (eq. 41e): of the whole plate, as the load is. Before the plate has moved both laws
// still stand at the same stress.
void LoadRecorder::add_error(const Simulation& simulation, io::LoadRow& row) {
    stress::Law& law = *simulation.state().law;
    if (!law.audits_load() || !simulation.anchored()) return;
    const double travel = simulation.travel() - before_.travel;
    const stress::VirtualWork work = law.take_missing_work();
    const double force = travel > 0 ? factor_ / travel : 0;
    bar_.add_to(row, force * work.missing, force * std::sqrt(work.variance));
}

// Forces times travel: docs/how_it_works.md (eq. 12c).
void LoadRecorder::add_drag(const Simulation& simulation, io::LoadRow& row) {
    if (!simulation.anchored()) return;
    const mpm::NodeWork& work = simulation.state().node_work;
    const Account now{factor_ * work.damping, factor_ * work.gained, row.kinetic_energy, row.plate_work,
                      simulation.travel()};
    const double kinetic = now.kinetic - before_.kinetic;
    const double scale = std::fmax(now.plate - before_.plate, unit_load_ * (now.travel - before_.travel));
    if (scale > 0) {  // the plate has moved
        row.damping_share = (now.damping - before_.damping) / scale;
        row.pic_share = (now.gained - before_.gained - kinetic) / scale;
        row.inertia_share = kinetic / scale;
    }
    before_ = now;
}

void LoadRecorder::archive(Archive& a) {
    std::vector<double> v = {next_,
                             steps_,
                             d_,
                             load_,
                             leading_,
                             trailing_,
                             plate_work_,
                             kinetic_share_max_,
                             last_,
                             before_.damping,
                             before_.gained,
                             before_.kinetic,
                             before_.plate,
                             before_.travel};
    for (const double one : bar_.state()) v.push_back(one);
    field_of_known_length(a, "load_recorder", v);
    require_state(v[0] >= 0, "load_recorder");
    next_ = v[0], steps_ = v[1], d_ = v[2], load_ = v[3], leading_ = v[4], trailing_ = v[5];
    plate_work_ = v[6], kinetic_share_max_ = v[7], last_ = v[8];
    before_ = {v[9], v[10], v[11], v[12], v[13]};
    bar_.set_state(v[14], v[15]);
}

}  // namespace sandgraph::simulation
