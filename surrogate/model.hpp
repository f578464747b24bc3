#pragma once
#include <array>
#include <cstddef>
#include <string>
#include <vector>

namespace sandgraph::surrogate {

inline constexpr int feature_version = 3;        // of features.hpp and element_update.hpp together
inline constexpr std::size_t feature_count = 9;  // in the order of features.hpp

// Most that a model may have; check_model refuses more.
inline constexpr std::size_t max_elements = 16, max_members = 16, max_width = 128;

// y = weight x + bias; weight is row-major [outputs x inputs].
struct Layer {
    std::size_t inputs = 0, outputs = 0;
    std::vector<double> weight, bias;
};

// Where sheared grains end up, however they began: at the void ratio `void_ratio` - `slope` p/100 kPa they
// neither dilate nor contract. From a plastic shear of about `mature` on, dilatancy is drawn there by `pull`
// a 0.04 of void ratio.
struct CriticalState {
    double mature = 0.1, pull = 0.5, void_ratio = 0.2535, slope = 0.0087;
};

// One member of the ensemble. M parallel frictional elements; no layers: constant coefficients.
struct Member {
    double exponent = 0.5;  // of p in the moduli
    double bulk = 1;        // K over the packing's own
    CriticalState critical;
    // Of the elements [M]: share of the shear modulus (> 0, sum 1), friction limit |t|/p (> 0), dilatancy
    // (dimensionless, before tanh).
    std::vector<double> share, strength, dilatancy;
    std::vector<Layer> layers;  // tanh between them, the last is linear: [feature_count] -> [3 M + 1]
};

// How far the network may multiply a coefficient, both up and down (>= 1).
struct Bounds {
    double shear = 3, strength = 3, bulk = 3;
};

// Trained range of a feature; outside it is clamped.
struct FeatureRange {
    double low = 0, high = 1;
};

// A trained stress law as plain numbers. What may be served is what check_model accepts.
struct Model {
    std::size_t elements = 8;  // M
    bool frictional = true;    // false: the elastic rung, no element slips
    double substep = 1e-4;     // largest strain increment integrated at once
    Bounds bounds;
    std::array<FeatureRange, feature_count> ranges;
    std::vector<Member> members;
    // Origin: features the weights were trained for, hash of the training data, words for people.
    int features = feature_version;
    std::string data_hash, description;
};

}  // namespace sandgraph::surrogate
