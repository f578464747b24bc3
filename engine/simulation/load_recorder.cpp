#include "simulation/load_recorder.hpp"

#include <algorithm>
#include <cmath>

#include "mpm/audit.hpp"

namespace sandgraph::simulation {
namespace {

constexpr double kQuasiStaticFrom = 0.005;  // d/B; before it the plate has done no work to compare with

}  // namespace

std::optional<io::LoadRow> LoadRecorder::after_step(const graph::Pull& pull) {
    const graph::GroundState& s = pull.state();
    d_ += pull.d_over_B(), load_ += factor_ * pull.load(), leading_ += factor_ * pull.leading(),
        trailing_ += factor_ * pull.trailing();
    plate_work_ += factor_ * mpm::plate_work(s.plate, s.contact.reaction, s.settings.dt);
    steps_ += 1;
    if (pull.d_over_B() < next_) return std::nullopt;
    io::LoadRow out = row(pull, load_ / steps_);
    if (pull.d_over_B() >= kQuasiStaticFrom)
        kinetic_share_max_ =
            std::fmax(kinetic_share_max_, out.kinetic_energy / std::max(plate_work_, 1e-300));
    while (next_ <= pull.d_over_B()) next_ += every_;
    steps_ = d_ = load_ = leading_ = trailing_ = 0;
    return out;
}

io::LoadRow LoadRecorder::row(const graph::Pull& pull, double load) const {
    const graph::GroundState& s = pull.state();
    io::LoadRow out;
    out.d_over_B = d_ / steps_, out.load = load, out.time = pull.time();
    out.leading = leading_ / steps_, out.trailing = trailing_ / steps_;
    out.kinetic_energy = factor_ * mpm::kinetic_energy(s.points, s.settings.scheme.mass_scaling);
    out.strain_work = factor_ * s.stress_work;
    out.plate_work = plate_work_;
    const stress::GrainUse grains = s.law->grain_use();
    out.rve_active = static_cast<double>(grains.active);
    out.dem_steps = static_cast<double>(grains.dem_steps);
    return out;
}

void LoadRecorder::archive(Archive& a) {
    std::vector<double> v = {next_, steps_, d_, load_, leading_, trailing_, plate_work_, kinetic_share_max_};
    field_of_known_length(a, "load_recorder", v);
    require_state(v[0] >= 0, "load_recorder");
    next_ = v[0], steps_ = v[1], d_ = v[2], load_ = v[3], leading_ = v[4], trailing_ = v[5];
    plate_work_ = v[6], kinetic_share_max_ = v[7];
}

}  // namespace sandgraph::simulation
