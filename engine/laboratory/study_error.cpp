#include "laboratory/study_error.hpp"

#include <algorithm>
#include <cmath>

namespace sandgraph::laboratory {
namespace {

double distance(const Stress& a, const Stress& b) {
    const double xx = a.xx - b.xx, yy = a.yy - b.yy, xy = a.xy - b.xy;
    return std::sqrt(xx * xx + yy * yy + 2 * xy * xy);
}

Stress mean(std::span<const Stress> values) {
    Stress sum;
    for (const Stress& s : values) sum.xx += s.xx, sum.yy += s.yy, sum.xy += s.xy;
    const auto n = static_cast<double>(values.size());
    return {sum.xx / n, sum.yy / n, sum.xy / n};
}

// What is compared: all stresses of a run, or the mean over its window.
std::vector<Stress> compared(const StudyRun& run, const StrainHistory& history) {
    if (history.window == 0) return run.stress;
    return {mean(std::span(run.stress).subspan(history.window))};
}

double scatter(std::span<const Stress> means, double floor) {
    if (means.size() < 2) return 0;
    const Stress centre = mean(means);
    double sum = 0;
    for (const Stress& s : means) sum += std::pow(distance(s, centre), 2);
    return std::sqrt(sum / static_cast<double>(means.size() - 1)) / std::max(mean_stress(centre), floor);
}

}  // namespace

StudyError study_error(std::span<const StudyRun> runs, std::span<const StudyRun> references,
                       const StrainHistory& history, double pressure_floor) {
    StudyError error;
    std::vector<Stress> means, own;
    double sum = 0, count = 0;
    for (std::size_t seed = 0; seed < runs.size(); ++seed) {
        const auto run = compared(runs[seed], history), reference = compared(references[seed], history);
        for (std::size_t k = 0; k < run.size(); ++k) {
            const double scale = std::max(mean_stress(reference[k]), pressure_floor);
            const double share = distance(run[k], reference[k]) / scale;
            sum += share * share, count += 1;
            error.pressure += mean_stress(reference[k]);
            error.max = std::max(error.max, share);
        }
        if (history.window != 0) means.push_back(reference.front()), own.push_back(run.front());
    }
    error.rms = std::sqrt(sum / count), error.pressure /= count;
    error.scatter = scatter(means, pressure_floor);
    if (!means.empty())
        error.of_means =
            distance(mean(own), mean(means)) / std::max(mean_stress(mean(means)), pressure_floor);
    return error;
}

}  // namespace sandgraph::laboratory
