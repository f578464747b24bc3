#pragma once
#include <filesystem>
#include <string>
#include <vector>

#include "laboratory/study_table.hpp"
#include "report/gnuplot.hpp"

namespace sandgraph::report {

// What one setting costs and errs.
struct StudyMark {
    double dem_steps = 0;
    double error = 0;  // rms stress error, share of p
};

struct StudyCurve {
    std::string label;  // the key that varies along it
    std::vector<StudyMark> marks;
};

struct StudyPanel {
    std::string title;
    std::vector<StudyCurve> curves;
    StudyMark standard, peers;      // the default setting and the literature's rule, marked
    double floor = 0, scatter = 0;  // drawn as lines where > 0: two fine answers; seed to seed
};

struct StudyPicture {
    std::string title;
    std::vector<StudyPanel> panels;
};

// One panel a history, one curve a key.
StudyPicture study_picture(const std::vector<laboratory::StudyRow>& rows, int seeds);

// Error against DEM steps on logarithmic axes, a panel each, three a row.
Plot study_plot(const StudyPicture& picture);
Picture draw_study_picture(const StudyPicture& picture, const std::filesystem::path& png);

}  // namespace sandgraph::report
