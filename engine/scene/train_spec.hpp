#pragma once
#include <cstdint>
#include <string>
#include <vector>

#include "scene/key_table.hpp"

namespace sandgraph::scene {

// In the order of their claim to ship: a rung must beat the ones before it on held-out histories.
enum class TrainRung { elastic, fitted, learned, mlp, gru };

// What a law is told of a packing besides its pressure, porosity and stress at the start.
enum class TrainTraits { all, stiffness, none };

// What a surrogate is trained from, and how.
struct TrainSpec {
    std::string file, text;
    std::string probe;              // probe recipe whose log is made first; "": none
    std::vector<std::string> logs;  // history logs of runs or probes
    int held_out_seeds = 1;         // packing seeds never trained on, the highest ones
    int validation_seeds = 1;       // those before them choose when to stop
    int held_out_every = 10;        // of the other seeds every so-manieth history is held out, too
    int histories = 0;              // trained on at most, drawn evenly; 0: all that are left
    double strain_max = 0.05;       // length of the path up to which a history trains

    TrainRung rung = TrainRung::learned;
    int members = 4;
    TrainTraits traits = TrainTraits::all;
    bool measured_critical = false;  // critical state as measured, not trained
    std::string start;               // model whose weights training starts from; "": drawn

    std::uint64_t seed = 1;
    int epochs = 60, patience = 20, batch = 128, threads = 1;
    double rate = 5e-3, rate_end = 3e-4, clip = 1, robust = 0.1, change = 0;
    bool friction = false;  // the loss compares s/p instead of s
    double step_share = 0.12, step_least = 2e-5, step_most = 1e-3;
    double lead_from = 0.02, lead_strain = 3e-3;
};

// The keys of a training recipe, filling `spec`, which must outlive the table.
KeyTable train_keys(TrainSpec& spec);

// Reads and checks a training recipe. Throws InputError.
TrainSpec read_train(const std::string& file);

}  // namespace sandgraph::scene
