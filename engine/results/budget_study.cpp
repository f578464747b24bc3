#include "results/budget_study.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "base/error.hpp"
#include "scene/alignment.hpp"

namespace sandgraph::results {
namespace {

using Settings = std::vector<std::string>;
namespace fs = std::filesystem;

double load_of(const FinishedRun& run) { return run.summary.breakout_load; }

// The plan, run by run.
class Study {
  public:
    explicit Study(const BudgetRequest& request)
        : request_(request),
          scene_(simulation::scene_of(request.run)),
          shared_(shared_geometry(request.run)),
          granular_(scene_.ground.law == scene::Law::rve) {}

    std::optional<Budget> run() {
        const auto own = made("run", {}, request_.run.mode);
        if (!own) return std::nullopt;
        describe(*own);
        if (shared_ && !compare(*own)) return std::nullopt;
        out_.items =
            budget_items(loads_, own->summary.number("drag_share"), own->summary.number("mesh_error"));
        out_.cost = cost_ / own->summary.cpu_s;
        return out_;
    }

  private:
    void describe(const FinishedRun& own) {
        const io::Summary& s = own.summary;
        out_.load = s.breakout_load, out_.breakout = s.breakout;
        out_.unit_load = own.scene.anchor.width *
                         (unit_weight(own) * own.scene.anchor.embedment_ratio * own.scene.anchor.width +
                          own.scene.ground.surcharge);
        // The others end soon after the breakout.
        end_ = std::min(scene_.anchor.pull_to, std::max(0.02, s.breakout_d_over_B) + 0.03);
    }

    // Whether all runs on the second grid, and the one it is held against, were made.
    bool compare(const FinishedRun& own) {
        const auto fine =
            shared_->empty() ? std::optional(own) : made("fine", ended(*shared_), request_.run.mode);
        if (!fine) return false;
        loads_.fine = load_of(*fine);
        const int packings = granular_ ? request_.samples : 1;
        for (int k = 0; k < packings; ++k)
            if (!draw(k)) return false;
        return slowly() && (scene_.mode != scene::Mode::screening || by_grains());
    }

    bool draw(int k) {
        Settings set = coarse();
        if (granular_) set.push_back(fmt::format("grains.seed={}", scene_.ground.grains.seed + k));
        const auto run = made(fmt::format("packing_{}", k + 1), set, request_.run.mode);
        if (run) loads_.coarse.push_back(load_of(*run));
        return run.has_value();
    }
    bool slowly() {
        Settings set = coarse();
        set.push_back(fmt::format("anchor.pull_rate={} m/s", 0.5 * scene_.anchor.pull_rate));
        const auto run = made("half_rate", set, request_.run.mode);
        if (run) loads_.slow = load_of(*run);
        return run.has_value();
    }
    bool by_grains() {
        Settings set = coarse();
        std::erase_if(
            set, [](const std::string& s) { return s.starts_with("surrogate.") || s.starts_with("gate."); });
        const auto run = made("grains", set, "full");
        if (run) loads_.grains = load_of(*run);
        return run.has_value();
    }

    Settings ended(Settings set) const {
        set.push_back(fmt::format("anchor.pull_to={}", end_));
        set.emplace_back("output.frames=[0]"), set.emplace_back("output.pictures=false");
        return set;
    }
    Settings coarse() const {
        Settings set = ended(*shared_);
        set.push_back(fmt::format("domain.cell={} m", 2 * scene_.domain.cell));
        return set;
    }

    std::optional<FinishedRun> made(const std::string& name, const Settings& set, const std::string& mode) {
        simulation::RunRequest run = request_.run;
        run.folder = (fs::path(request_.run.folder) / name).string(), run.mode = mode;
        run.set.insert(run.set.end(), set.begin(), set.end());
        auto out = kept_run(run, request_.draw);
        if (out) cost_ += out->summary.cpu_s;
        return out;
    }

    const BudgetRequest& request_;
    scene::Scene scene_;
    std::optional<Settings> shared_;
    bool granular_;
    double end_ = 0, cost_ = 0;
    BudgetLoads loads_;
    Budget out_;
};

double multiple_from(double length, double of) { return std::ceil(length / of - 1e-6) * of; }

}  // namespace

std::optional<Settings> shared_geometry(const simulation::RunRequest& request) {
    const scene::Scene s = simulation::scene_of(request);
    const double cell = 2 * s.domain.cell, spacing = 2 * scene::point_spacing(s.domain);
    Settings set;
    const auto put = [&set](const char* key, double value, double was) {
        if (std::fabs(value - was) > 1e-9 * value) set.push_back(fmt::format("{}={:.12g} m", key, value));
    };
    const double thickness = multiple_from(s.anchor.thickness, spacing);
    put("domain.width", multiple_from(s.domain.width, cell), s.domain.width);
    put("domain.depth", multiple_from(s.domain.depth, cell), s.domain.depth);
    put("anchor.thickness", thickness, s.anchor.thickness);
    if (s.anchor.orientation == scene::Orientation::vertical) {
        const double offset = std::fmod(0.5 * thickness, spacing);
        put("anchor.position", offset + spacing * std::round((s.anchor.position - offset) / spacing),
            s.anchor.position);
    }
    try {  // each grid must hold it
        simulation::RunRequest trial = request;
        trial.set.insert(trial.set.end(), set.begin(), set.end());
        simulation::scene_of(trial);
        trial.set.push_back(fmt::format("domain.cell={} m", cell));
        simulation::scene_of(trial);
    } catch (const InputError&) {
        return std::nullopt;
    }
    return set;
}

std::optional<Budget> budget(const BudgetRequest& request) {
    const scene::Scene scene = simulation::scene_of(request.run);
    if (!scene.anchor.present || !scene.bodies.empty())
        throw InputError({request.run.scene, 0}, "anchor", "a budget is of the breakout load of one plate",
                         "budget a scene with an [anchor] and no [[body]]");
    return Study(request).run();
}

}  // namespace sandgraph::results
