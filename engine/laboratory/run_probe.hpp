#pragma once
#include "graph/rve_law.hpp"
#include "laboratory/probe_plan.hpp"
#include "scene/probe_spec.hpp"

namespace sandgraph::laboratory {

// A packing ready to be probed.
struct ProbeSample {
    graph::RowPacking row;
    stress::PackingTraits traits;
};

// Drives the history of `job` and its twins on their packings, from rest; rows of one history after the
// other, in sequence. A history ends early at the recipe's stop pressure, where the packing cannot follow,
// or when it stays loose; twins repeat what their original went through, the finer one its beginning.
std::vector<io::HistoryRow> run_probe(const ProbeJob& job, const ProbePlan& plan,
                                      const std::vector<ProbeSample>& samples, const scene::ProbeSpec& spec);

}  // namespace sandgraph::laboratory
