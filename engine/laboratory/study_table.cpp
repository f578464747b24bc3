#include "laboratory/study_table.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace sandgraph::laboratory {
namespace {

StudyRow row(const StrainHistory& history, const StudySetting& setting, const std::vector<StudyRun>& runs) {
    StudyRow out;
    out.history = history, out.setting = setting;
    const auto n = static_cast<double>(runs.size());
    for (const StudyRun& run : runs) {
        out.dem_steps += static_cast<double>(run.dem_steps) / n;
        out.updates += static_cast<double>(run.updates) / n;
        out.seconds += run.seconds / n;
        out.failures += static_cast<double>(run.failures);
    }
    return out;
}

double percent(double share) { return 100 * share; }

}  // namespace

std::vector<StudyRow> study_rows(const StrainHistory& history, const std::vector<StudySetting>& settings,
                                 const std::vector<std::vector<StudyRun>>& runs) {
    std::vector<StudyRow> rows;
    for (std::size_t k = 0; k < settings.size(); ++k) {
        rows.push_back(row(history, settings[k], runs[k]));
        rows.back().error = study_error(runs[k], runs[study_reference], history, study_floor);
    }
    for (StudyRow& r : rows) r.of_peers = r.dem_steps / std::max(1.0, rows[study_peers].dem_steps);
    return rows;
}

std::string study_csv(const std::vector<StudyRow>& rows) {
    std::string text =
        "history,key,value,strain_length,dem_steps,dem_steps_per_strain,share_of_peers,updates,error_rms,"
        "error_max,error_of_means,seed_scatter,pressure_Pa,failures,wall_s\n";
    for (const StudyRow& r : rows) {
        const double length = r.history.length();
        text += fmt::format(
            "{},{},{:g},{:.6g},{:.0f},{:.6g},{:.6g},{:.1f},{:.6g},{:.6g},{:.6g},{:.6g},{:.4g},{:g},{:.4g}\n",
            r.history.name, r.setting.key, r.setting.value, length, r.dem_steps, r.dem_steps / length,
            r.of_peers, r.updates, r.error.rms, r.error.max, r.error.of_means, r.error.scatter,
            r.error.pressure, r.failures, r.seconds);
    }
    return text;
}

std::string study_text(const std::vector<StudyRow>& rows) {
    std::string text, history;
    for (const StudyRow& r : rows) {
        if (r.history.name != history) {
            history = r.history.name;
            text += fmt::format("\n{:<32}{:>11}{:>10}{:>9}{:>9}{:>9}{:>9}{:>9}   (mean p {:.1f} kPa)\n",
                                history, "DEM steps", "of peers", "rms %p", "max %p", "means %p", "seeds %p",
                                "wall s", r.error.pressure / 1000);
        }
        const std::string name =
            r.setting.key + (r.setting.value == 0 && r.setting.key.find('_') == std::string::npos
                                 ? std::string()
                                 : fmt::format(" = {:g}", r.setting.value));
        text += fmt::format("  {:<30}{:>11.0f}{:>10.3f}{:>9.3f}{:>9.3f}{:>9.3f}{:>9.3f}{:>9.3f}{}\n", name,
                            r.dem_steps, r.of_peers, percent(r.error.rms), percent(r.error.max),
                            percent(r.error.of_means), percent(r.error.scatter), r.seconds,
                            r.failures > 0 ? fmt::format("  {:g} failed", r.failures) : "");
    }
    return text;
}

}  // namespace sandgraph::laboratory
