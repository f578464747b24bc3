#pragma once
#include <span>

#include "laboratory/study_run.hpp"

namespace sandgraph::laboratory {

// Distance of stresses from the reference's, Frobenius norm as a share of the reference's mean stress (of the
// pressure floor where that is higher). Past the peak: of the mean stresses over the window, one a seed.
struct StudyError {
    double rms = 0, max = 0;
    double pressure = 0;  // mean of the reference's mean stress over what is compared [Pa]
    // Only past the peak: scatter of the reference's window means over the seeds (standard deviation, the
    // same share): what another sample of the same sand would change. 0 for one seed.
    double scatter = 0;
    // Only past the peak: distance of the mean over the seeds from the reference's, the same share. By chance
    // alone it comes to about scatter sqrt(2 / seeds).
    double of_means = 0;
};

// `runs` and `references`: one a seed, in the same order.
StudyError study_error(std::span<const StudyRun> runs, std::span<const StudyRun> references,
                       const StrainHistory& history, double pressure_floor);

}  // namespace sandgraph::laboratory
