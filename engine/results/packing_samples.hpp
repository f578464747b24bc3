#pragma once
#include <optional>
#include <string>
#include <vector>

#include "base/statistics.hpp"
#include "results/kept_run.hpp"

// One scene with several base packings of its sand, one after the other: what a single packing does not tell.
namespace sandgraph::results {

struct PackingSamples {
    std::vector<FinishedRun> runs;  // by seed, the scene's own first
    std::vector<std::uint64_t> seeds;
    Sample load, n_gamma;  // of those that broke out; [N/m], -
};

// `count` runs in the folders sample_1 ... of the request's; those that this program has finished are kept.
// Empty when one was stopped; InputError for ground without packings.
std::optional<PackingSamples> run_samples(const simulation::RunRequest& request, int count,
                                          const DrawPictures& draw);

// sample,seed,breakout,load_N_per_m,d_over_B,n_gamma,late_load_N_per_m,cpu_s; empty where there is no value.
std::string to_csv(const PackingSamples& samples);
std::string samples_text(const PackingSamples& samples);

}  // namespace sandgraph::results
