#include <algorithm>

#include "app/study_table.hpp"

namespace sandgraph::app {
namespace {

report::StudyMark mark(const StudyRow& r) { return {r.dem_steps, r.error.rms}; }

// One curve a varied key. The default lies on all of them.
std::vector<report::StudyCurve> curves(const std::vector<StudyRow>& panel) {
    std::vector<report::StudyCurve> out;
    for (std::size_t k = study_default + 1; k < panel.size(); ++k) {
        if (out.empty() || out.back().label != panel[k].setting.key)
            out.push_back({panel[k].setting.key, {mark(panel[study_default])}});
        out.back().marks.push_back(mark(panel[k]));
    }
    for (report::StudyCurve& curve : out)
        std::sort(curve.marks.begin(), curve.marks.end(),
                  [](const auto& a, const auto& b) { return a.dem_steps < b.dem_steps; });
    return out;
}

report::StudyPanel panel_of(const std::vector<StudyRow>& panel) {
    const StudyRow& first = panel.front();
    const bool means = first.history.window != 0;
    return {first.history.name + (means ? " (window means)" : ""),
            curves(panel),
            mark(panel[study_default]),
            mark(panel[study_peers]),
            panel[study_twin].error.rms,
            first.error.scatter};
}

}  // namespace

report::StudyPicture study_picture(const std::vector<StudyRow>& rows, int seeds) {
    report::StudyPicture picture{
        "Stress error of an RVE against its DEM steps, seeds: " + std::to_string(seeds), {}};
    for (auto begin = rows.begin(); begin != rows.end();) {
        const auto end = std::find_if(
            begin, rows.end(), [&](const StudyRow& r) { return r.history.name != begin->history.name; });
        picture.panels.push_back(panel_of({begin, end}));
        begin = end;
    }
    return picture;
}

}  // namespace sandgraph::app
