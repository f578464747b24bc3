#include "results/packing_samples.hpp"

#include <fmt/format.h>

#include <cmath>

#include "base/error.hpp"

namespace sandgraph::results {
namespace {

std::string number(double value) { return std::isfinite(value) ? fmt::format("{:.9g}", value) : ""; }

void summarise(PackingSamples& s) {
    std::vector<double> load, factor;
    for (const FinishedRun& run : s.runs)
        if (run.summary.breakout)
            load.push_back(run.summary.breakout_load), factor.push_back(run.summary.n_gamma);
    s.load = sample_of(load), s.n_gamma = sample_of(factor);
}

}  // namespace

std::optional<PackingSamples> run_samples(const simulation::RunRequest& request, int count,
                                          const DrawPictures& draw) {
    const scene::Scene scene = simulation::scene_of(request);
    if (scene.ground.law != scene::Law::rve || !scene.ground.grains.packing.empty())
        throw InputError({"--samples", 0}, std::to_string(count), "this ground draws no packings by seed",
                         "leave it out, or take [grains] with a density");
    PackingSamples out;
    for (int k = 0; k < count; ++k) {
        out.seeds.push_back(scene.ground.grains.seed + static_cast<std::uint64_t>(k));
        simulation::RunRequest one = request;
        one.folder = (std::filesystem::path(request.folder) / fmt::format("sample_{}", k + 1)).string();
        one.set.push_back(fmt::format("grains.seed={}", out.seeds.back()));
        auto run = kept_run(one, draw);
        if (!run) return std::nullopt;
        out.runs.push_back(std::move(*run));
    }
    summarise(out);
    return out;
}

std::string to_csv(const PackingSamples& s) {
    std::string text = "sample,seed,breakout,load_N_per_m,d_over_B,n_gamma,late_load_N_per_m,cpu_s\n";
    for (std::size_t k = 0; k < s.runs.size(); ++k) {
        const io::Summary& one = s.runs[k].summary;
        text += fmt::format("{},{},{},{},{},{},{},{:.1f}\n", k + 1, s.seeds[k], one.breakout ? "yes" : "no",
                            number(one.breakout_load), number(one.breakout_d_over_B), number(one.n_gamma),
                            number(one.late_load), one.cpu_s);
    }
    return text;
}

std::string samples_text(const PackingSamples& s) {
    if (s.load.count < 2)
        return fmt::format("{} of {} packings broke out: no mean\n", s.load.count, s.runs.size());
    return fmt::format(
        "{} of {} packings broke out: {:.4g} +- {:.2g} kN/m, N_gamma {:.3g} +- {:.2g} (95 % of the mean); "
        "they scatter by {:.1f} %\n",
        s.load.count, s.runs.size(), s.load.mean / 1e3, s.load.ci95 / 1e3, s.n_gamma.mean, s.n_gamma.ci95,
        100 * s.load.deviation / s.load.mean);
}

}  // namespace sandgraph::results
