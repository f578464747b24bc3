#include "simulation/run_session.hpp"

#include <fmt/format.h>

#include <ctime>

#include "base/console.hpp"
#include "base/error.hpp"
#include "base/hash.hpp"
#include "base/process.hpp"
#include "base/revision.hpp"
#include "io/checkpoint.hpp"
#include "scene/scene_hash.hpp"
#include "simulation/build_screening.hpp"
#include "simulation/make_frame.hpp"
#include "simulation/progress.hpp"

namespace sandgraph::simulation {
namespace {

constexpr double kSolidDensity =
    2650;                          // quartz [kg/m3]: turns the density of a closed-form law into porosity
constexpr double kReached = 1e-9;  // slack on d/B marks

double cpu_clock() { return static_cast<double>(std::clock()) / CLOCKS_PER_SEC; }

std::string hash_of(const scene::Scene& scene) { return hex(scene::scene_hash(scene)); }

io::RunInfo info_of(const scene::Scene& scene, int threads) {
    const char* mode = scene.mode == scene::Mode::full ? "full" : "screening";
    return {scene.text, hash_of(scene), version(), revision(), mode, threads};
}

io::RunFile open_file(const scene::Scene& scene, const RunOptions& o) {
    return o.resume ? io::RunFile::resume(o.folder, info_of(scene, o.threads))
                    : io::RunFile::create(o.folder, info_of(scene, o.threads));
}

std::vector<Vec2> positions(const mpm::Points& points) {
    std::vector<Vec2> out;
    for (std::size_t p = 0; p < points.size(); ++p) out.emplace_back(points.x[p], points.y[p]);
    return out;
}

}  // namespace

RunSession::RunSession(const scene::Scene& scene, const packings::PreparedGround& ground,
                       const RunOptions& options)
    : scene_(scene),
      options_(options),
      pull_(build_pull(scene, ground)),
      start_(positions(pull_->state().points)),
      initial_porosity_(1 - ground.density / kSolidDensity),
      loads_(scene.output.load_every, whole_plate_factor(scene)),
      regions_(scene, *pull_, initial_porosity_),
      file_(open_file(scene, options)) {
    file_.follow(regions_.regions());
    if (scene.output.history) history_.emplace(scene, ground, *pull_, options.folder, options.resume);
    if (options.resume) resume();
}

void RunSession::resume() {
    io::CheckpointReader reader(options_.folder / io::checkpoint_name, hash_of(scene_));
    if (!reader.notice().empty()) notice(reader.notice());
    try {
        archive(reader);
    } catch (const StateError& error) {
        throw InputError({(options_.folder / io::checkpoint_name).string()},
                         "the checkpoint is none of this program's runs of this scene",
                         fmt::format("{}; it was written by revision {}, this is {}", error.what(),
                                     reader.header().git, revision()),
                         "resume with the program that wrote it, or start anew, without --resume");
    }
}

// run.h5 comes last: it is cut back to the checkpoint, and whatever is refused before leaves the folder
// alone.
void RunSession::archive(Archive& a) {
    pull_->archive(a);
    loads_.archive(a);
    std::vector<double> clocks = {wall_seconds(), cpu_seconds(), last_load_};
    field_of_known_length(a, "session", clocks);
    if (history_) history_->archive(a);
    file_.archive(a);
    if (!a.reading()) return;
    regions_.resume_at(pull_->d_over_B());
    wall_before_ = clocks[0], cpu_before_ = clocks[1], last_load_ = clocks[2];
    timing_before_ = file_.record().timing;
    skip_frames();
}

// Frames that the run has passed; the marks may be others than before, they change no physics.
void RunSession::skip_frames() {
    const auto& marks = scene_.output.frames;
    while (next_frame_ < marks.size() && pull_->d_over_B() >= marks[next_frame_] - kReached) ++next_frame_;
}

RunEnd RunSession::run() {
    wall_start_ = last_checkpoint_ = wall_clock(), cpu_start_ = cpu_clock();
    catch_interrupts();
    Progress progress;
    while (pull_->d_over_B() < options_.until - kReached && !interrupted()) {
        pull_->step();
        after_step();
        progress.update({pull_->steps(), pull_->d_over_B(), options_.until, last_load_,
                         pull_->state().law->grain_use().active});
    }
    const bool all = went_all_the_way();
    if (all) pull_->state().law->conclude(pull_->d_over_B());
    all ? wind_up() : checkpoint();
    if (history_ && !all) history_->write();
    return pull_->d_over_B() < options_.until - kReached ? RunEnd::interrupted : RunEnd::finished;
}

bool RunSession::went_all_the_way() const { return pull_->d_over_B() >= scene_.anchor.pull_to - kReached; }

void RunSession::after_step() {
    if (const auto row = loads_.after_step(*pull_)) {
        last_load_ = row->load;
        auto regions = std::make_shared<std::vector<io::RegionRow>>(regions_.rows(*pull_));
        writer_.post([this, row, regions] { file_.append(*row), file_.append(*regions); });
    }
    if (history_) history_->after_step(*pull_, writer_);
    regions_.keep_packings(*pull_, options_.folder, writer_);
    const auto& marks = scene_.output.frames;
    if (next_frame_ < marks.size() && pull_->d_over_B() >= marks[next_frame_] - kReached) record_frame();
    if (wall_clock() - last_checkpoint_ > scene_.output.checkpoint_every) checkpoint();
}

void RunSession::record_frame() {
    skip_frames();
    auto frame = std::make_shared<io::Frame>(
        make_frame(*pull_, start_, initial_porosity_, scene_.ground.grains.material));
    writer_.post([this, frame] { file_.append(*frame); });
}

void RunSession::note_costs() {
    writer_.drain();
    const stress::Law& law = *pull_->state().law;
    file_.set_screening(screening_record(law));
    const stress::GrainUse grains = law.grain_use();
    file_.set_counter("active", static_cast<double>(grains.active));
    file_.set_counter("dem_steps", static_cast<double>(grains.dem_steps));
    file_.set_counter("updates", static_cast<double>(grains.updates));
    file_.set_counter("failures", static_cast<double>(grains.failures));
    for (const graph::PhaseTime& t : pull_->graph().times()) {
        const auto before = timing_before_.find(t.name);
        file_.set_timing(t.name, t.seconds + (before == timing_before_.end() ? 0 : before->second));
    }
}

void RunSession::wind_up() {
    note_costs();
    file_.commit();
    if (history_) history_->write();
}

void RunSession::discard_restart_files() { io::remove_restart_files(options_.folder); }

void RunSession::checkpoint() {
    note_costs();
    io::CheckpointWriter out(options_.folder / io::checkpoint_name,
                             {hash_of(scene_), revision(), pull_->d_over_B()});
    archive(out);
    out.commit();
    last_checkpoint_ = wall_clock();
}

double RunSession::wall_seconds() const {
    return wall_before_ + (wall_start_ > 0 ? wall_clock() - wall_start_ : 0);
}
double RunSession::cpu_seconds() const {
    return cpu_before_ + (wall_start_ > 0 ? cpu_clock() - cpu_start_ : 0);
}

}  // namespace sandgraph::simulation
