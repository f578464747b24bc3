#include "simulation/run_recorders.hpp"

#include "base/hash.hpp"
#include "base/revision.hpp"
#include "scene/scene_hash.hpp"
#include "simulation/build_screening.hpp"
#include "simulation/scene_spec.hpp"

namespace sandgraph::simulation {
namespace {

constexpr double kSolidDensity = 2650;  // quartz [kg/m3]: a closed-form law's density tells its porosity

double initial_porosity(const packings::PreparedGround& ground) { return 1 - ground.density / kSolidDensity; }

io::RunInfo info_of(const scene::Scene& scene, int threads) {
    const char* mode = scene.mode == scene::Mode::full ? "full" : "screening";
    return {scene.text, hex(scene::scene_hash(scene)), version(), revision(), mode, threads};
}

io::RunFile open_file(const scene::Scene& scene, const RunOptions& o, bool load_audited) {
    return o.resume ? io::RunFile::resume(o.folder, info_of(scene, o.threads))
                    : io::RunFile::create(o.folder, info_of(scene, o.threads), load_audited);
}

}  // namespace

RunRecorders::RunRecorders(const scene::Scene& scene, const packings::PreparedGround& ground,
                           Simulation& simulation, const RunOptions& options)
    : folder_(options.folder),
      loads_(scene.output.load_every, whole_plate_factor(scene), unit_load(scene, ground)),
      frames_(scene, simulation, initial_porosity(ground)),
      regions_(scene, simulation, initial_porosity(ground)),
      file_(open_file(scene, options, simulation.state().law->audits_load())) {
    file_.follow(regions_.regions());
    if (scene.output.history) history_.emplace(scene, ground, simulation, options.folder, options.resume);
}

void RunRecorders::after_step(const Simulation& simulation) {
    if (const auto row = loads_.after_step(simulation)) {
        auto regions = std::make_shared<std::vector<io::RegionRow>>(regions_.rows(simulation));
        writer_.post([this, row, loaded = simulation.anchored(), regions] {
            if (loaded) file_.append(*row);
            file_.append(*regions);
        });
    }
    if (history_) history_->after_step(simulation, writer_);
    regions_.keep_packings(simulation, folder_, writer_);
    if (auto due = frames_.after_step(simulation)) {
        auto frame = std::make_shared<io::Frame>(std::move(*due));
        writer_.post([this, frame] { file_.append(*frame); });
    }
}

bool RunRecorders::look_by(double mark) const {
    return frames_.due_by(mark) || regions_.keeps_by(mark) ||
           (!regions_.regions().empty() && loads_.due_by(mark));
}

void RunRecorders::settle(const Simulation& simulation) {
    writer_.drain();
    const stress::Law& law = *simulation.state().law;
    file_.set_screening(screening_record(law));
    const stress::GrainUse grains = law.grain_use();
    file_.set_counter("active", static_cast<double>(grains.active));
    file_.set_counter("dem_steps", static_cast<double>(grains.dem_steps));
    file_.set_counter("updates", static_cast<double>(grains.updates));
    file_.set_counter("failures", static_cast<double>(grains.failures));
    for (const graph::PhaseTime& t : simulation.graph().times()) {
        const auto before = timing_before_.find(t.name);
        file_.set_timing(t.name, t.seconds + (before == timing_before_.end() ? 0 : before->second));
    }
}

void RunRecorders::write_history() {
    if (history_) history_->write();
}

void RunRecorders::archive(Archive& a, const Simulation& simulation) {
    loads_.archive(a);
    if (history_) history_->archive(a);
    file_.archive(a);
    if (!a.reading()) return;
    regions_.resume_at(simulation.mark());
    frames_.resume_at(simulation.mark());
    timing_before_ = file_.record().timing;
}

}  // namespace sandgraph::simulation
