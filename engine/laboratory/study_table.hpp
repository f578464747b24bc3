#pragma once
#include <string>
#include <vector>

#include "laboratory/study_error.hpp"
#include "laboratory/study_setting.hpp"

namespace sandgraph::laboratory {

// One history under one setting, means over the seeds.
struct StudyRow {
    StrainHistory history;
    StudySetting setting;
    double dem_steps = 0, updates = 0, seconds = 0;  // of one seed
    double of_peers = 0;                             // DEM steps as a share of the peers' rule's
    double failures = 0;                             // refused or diverged updates, all seeds
    StudyError error;
};

// `runs[setting][seed]` of one history.
std::vector<StudyRow> study_rows(const StrainHistory& history, const std::vector<StudySetting>& settings,
                                 const std::vector<std::vector<StudyRun>>& runs);

// Column names in the first line; strain_length is what the steps per unit strain refer to.
std::string study_csv(const std::vector<StudyRow>& rows);
std::string study_text(const std::vector<StudyRow>& rows);  // for the terminal

}  // namespace sandgraph::laboratory
