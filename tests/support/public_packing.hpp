#pragma once
#include "dem/fast/fast.hpp"
#include "dem/packing/csv.hpp"
#include "graph/rve_law.hpp"
#include "stress/surrogate.hpp"
#include "support/paths.hpp"

namespace sandgraph::support {

// The public dense packing at 32 kPa, at rest.
inline graph::RowPacking public_packing() {
    static const graph::RowPacking row = [] {
        dem::FastAssembly a(dem::read_packing_csv(sandgraph::test::test_data("/yade/packing_dense_p32.csv")),
                            dem::Material{});
        a.step(Mat2::Zero(), 1e-5, 4000);
        return graph::RowPacking{dem::compact(a.packing(), dem::Material{}, a.stress()), {2.0e7, 1.4e7}};
    }();
    return row;
}

inline stress::PackingTraits public_traits() {
    return {
        mean_stress(tension_positive(public_packing().packing->stress)), 0.16, 2.0e7, 1.4e7, 3.5, 0, 0, 0.5};
}

// The watched updates of the last step.
inline std::vector<dem::RveUpdate> watched(const stress::Law& law) {
    std::vector<dem::RveUpdate> out;
    law.each_watched_update([&](const dem::RveUpdate& update) { out.push_back(update); });
    return out;
}

}  // namespace sandgraph::support
