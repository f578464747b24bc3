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

// [steps]: how increments are composed to the steps a law is trained on: a step ends when its strain reaches
// `share` of the strain gone through since the start or the last turn, within [least, most].
struct CutRule {
    double least = 2e-5, most = 1e-3;
    double share = 0.12;
    // Past a path of `lead_from` the measured pressure leads: over a strain of `lead_strain` a rollout's
    // error of p decays by 1/e (fully so past twice that path). 0: never. Where grains flow, p under given
    // strain is weather (two packings part by several p), but q/p and dilation at a given p and void ratio
    // are climate.
    double lead_from = 0.02, lead_strain = 3e-3;
};

// [training], too: how an error counts.
struct LossScale {
    double robust = 0.1;  // error, share of p, beyond which the loss grows linearly
    // While the measured stress has moved by less than this share of p since the start, the error counts as a
    // share of that way: stiffness at small strain carries a foundation long before anything fails. 0: never.
    double change = 0;
    // Deviators are compared as shares of the answer's and of the measured p. What sand bears at given strain
    // is strength times a pressure that is weather: an answer whose p is low must not make up for it by
    // friction, which the ground then has at any p.
    bool friction = false;
};

// [training]: how the members are fitted.
struct TrainOptions {
    std::uint64_t seed = 1;
    int epochs = 60;
    int patience = 20;  // epochs without a better validation error before a member stops to count
    int batch = 128;    // histories
    double rate = 5e-3, rate_end = 3e-4;  // of Adam; falls along half a cosine
    double clip = 1;                      // largest norm of a member's gradient
    LossScale scale;
};

// What a surrogate is trained from, and how.
struct TrainSpec {
    std::string file, text;
    std::string probe;              // probe recipe whose log is made first; "": none
    std::vector<std::string> logs;  // history logs of runs or probes
    int held_out_seeds = 1;         // packing seeds never trained on, the highest ones
    int validation_seeds = 1;       // those before them choose when to stop
    bool seeds_asked = false;       // one of the two stands in the recipe
    int held_out_every = 10;        // of the other seeds every so-manieth history is held out, too
    int histories = 0;              // trained on at most, drawn evenly; 0: all that are left
    double strain_max = 0.05;       // length of the path up to which a history trains

    TrainRung rung = TrainRung::learned;
    int members = 4;
    TrainTraits traits = TrainTraits::all;
    bool measured_critical = false;  // critical state as measured, not trained
    std::string start;               // model whose weights training starts from; "": drawn
    std::string guard;               // log of probes that nothing is trained on: has it forgotten them?

    TrainOptions training;
    int threads = 1;  // of libtorch
    CutRule steps;
};

// The keys of a training recipe, filling `spec`, which must outlive the table.
KeyTable train_keys(TrainSpec& spec);

// The folder that whoever makes the model `out` locks meanwhile: model, card, probes and state belong
// together.
std::string training_folder(const std::string& out);

// Reads and checks a training recipe. Throws InputError.
TrainSpec read_train(const std::string& file);

}  // namespace sandgraph::scene
