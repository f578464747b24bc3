#pragma once
#include <numeric>

#include "base/random.hpp"
#include "training/history.hpp"

namespace sandgraph::support {

inline io::HistoryPacking random_packing(Random& random, std::int64_t seed) {
    io::HistoryPacking packing;
    packing.seed = seed;
    packing.target_porosity = random.uniform(0.16, 0.2);
    const double p = 1e4 * std::exp(random.uniform(-2, 2));
    packing.traits = {p, packing.target_porosity, 2e7, 1.2e7, 3.5, random.uniform(-0.01, 0.01), 0.005, 0.5};
    packing.stress = (Mat2() << p, 0.02 * p, 0.02 * p, p).finished();
    return packing;
}

// Strain paths of a few legs with spin from packings of different seeds; the stresses are those at the start
// until a test sets them.
inline training::HistorySet random_histories(int count, int rows) {
    Random random(3);
    training::HistorySet set;
    for (int h = 0; h < count; ++h) {
        set.packings.push_back(random_packing(random, h % 5));
        training::History history;
        history.packing = h;
        Mat2 gradient = Mat2::Zero();
        for (int row = 0; row < rows; ++row) {
            if (row % 20 == 0)
                for (int k = 0; k < 4; ++k) gradient(k / 2, k % 2) = random.uniform(-1, 1);
            if (row % 20 == 0) gradient -= 0.45 * gradient.trace() * Mat2::Identity();
            const double size = 1e-5 * std::exp(0.05 * row);
            history.F_inc.push_back(Mat2::Identity() + size * gradient);
            history.stress.push_back(tension_positive(set.packings.back().stress));
        }
        set.histories.push_back(std::move(history));
    }
    return set;
}

}  // namespace sandgraph::support
