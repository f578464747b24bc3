#pragma once
#include "graph/screening/law.hpp"
#include "graph/stress_arithmetic.hpp"
#include "tests/support/element_surrogate.hpp"
#include "tests/support/public_packing.hpp"
#include "tests/support/table1_options.hpp"

// A few points under a law, driven by given increments.
namespace sandgraph::graph {

using support::watched;

inline ScreeningSetup setup_of(std::size_t points, double strain) {
    ScreeningSetup s;
    s.grains = {
        {}, support::table1_options(), {support::public_packing()}, std::vector<std::int32_t>(points, 0)};
    s.surrogate = std::make_shared<support::ElementSurrogate>();
    s.traits = {support::public_traits()};
    s.gate.strain = strain;
    s.gate.stress_ratio = s.gate.spread = s.gate.distance = 1e9;
    s.gate.second_order_work = s.gate.acoustic = -1e9;
    s.audit.share = 0, s.audit.load_points = 0;
    s.hand_over.blend_steps = 40;
    return s;
}

template <class AnyLaw>
struct Bench {
    Bench(std::size_t points, AnyLaw made) : law(std::move(made)) {
        for (std::size_t p = 0; p < points; ++p) {
            ids.push_back(static_cast<std::int32_t>(p));
            x.push_back(static_cast<double>(p)), y.push_back(0), volume.push_back(1);
        }
        F.assign(points, Mat2::Identity()), stress.resize(points);
        law.initialise(batch());
    }
    stress::Batch batch() { return {ids, F, stress, 1e-4}; }
    AnyLaw law;
    std::vector<std::int32_t> ids;
    std::vector<Mat2> F;
    std::vector<Stress> stress;
    std::vector<double> x, y, volume;
};

// Points strain the more the higher their id; the last one turns as well.
template <class AnyLaw>
void shear(Bench<AnyLaw>& b, int steps) {
    for (std::size_t p = 0; p < b.F.size(); ++p) {
        const double e = 2e-6 * static_cast<double>(p);
        b.F[p] << 1 + e, 0, 0, 1 - e;
    }
    b.F.back()(0, 1) = 1e-6, b.F.back()(1, 0) = -1e-6;
    for (int k = 0; k < steps; ++k) b.law.update(b.batch());
}

inline Bench<ScreeningLaw> screening(std::size_t points, const ScreeningSetup& setup) {
    return {points, ScreeningLaw(setup)};
}
inline Bench<RveLaw> full(std::size_t points) { return {points, RveLaw(setup_of(points, 0).grains)}; }

inline double share(const Stress& a, const Stress& b) { return norm(difference(a, b)) / mean_stress(b); }

}  // namespace sandgraph::graph
