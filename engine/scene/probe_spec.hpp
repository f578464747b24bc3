#pragma once
#include <string>
#include <vector>

#include "scene/key_table.hpp"
#include "scene/scene.hpp"

namespace sandgraph::scene {

// The packings to probe: one for each combination of seed, porosity and pressure.
struct ProbePackings {
    int seeds = 6;
    std::int64_t first_seed = 1;
    std::vector<double> porosities = {0.16, 0.18, 0.20};  // of the base packings
    int pressures = 6;                                    // of each, spread log-uniformly
    double pressure_min = 500, pressure_max = 500e3;      // [Pa]
};

// How many strain paths of each kind, and how long.
struct ProbePaths {
    int proportional = 150, constant_volume = 100, constant_pressure = 350, cyclic = 200, dither = 100,
        rotating = 150, mixed = 350, flow = 250;
    double length_min = 1e-4, length_max = 0.3;         // sum of |strain increment|, log-uniform
    double increment_min = 1e-5, increment_max = 5e-4;  // |strain increment| of an update, log-uniform
    int rows_max = 1000;                                // updates of a history at most
    int dither_rows = 2000;                             // of a dithering history
    int flow_rows = 4000;                               // of a flowing one
    double flow_length = 1;                             // of a leg of flow, at most
    double pressure_stop = 1e6;                         // mean stress at which a history ends [Pa]
    int twin_every = 10;                                // every how many-th history has twins; 0: none
};

// Strain paths for packings, to train a surrogate without a run.
struct ProbeSpec {
    std::string file, text;
    std::uint64_t seed = 1;
    ProbePackings packings;
    ProbePaths paths;
    Grains grains;  // without density, porosity, seed: [packings] has them
    graph::RveSettings rve;
};

// The keys of a probe recipe, filling `probe`, which must outlive the table.
KeyTable probe_keys(ProbeSpec& probe);

// Reads and checks a probe recipe. Throws InputError.
ProbeSpec read_probe(const std::string& file);

}  // namespace sandgraph::scene
