#include "training/known_traits.hpp"

#include <cmath>
#include <set>

#include "base/contracts.hpp"

namespace sandgraph::training {
namespace {

using stress::PackingTraits;

// value ~ c p^m, least squares in the logarithms.
struct PowerLaw {
    double constant = 0, slope = 0;
    double at(double p) const { return std::exp(constant + slope * std::log(p)); }
};

PowerLaw fit(const HistorySet& set, const std::set<std::int32_t>& packings, double PackingTraits::*trait) {
    SG_EXPECT(!packings.empty() && all_below(packings, set.packings.size()));
    double n = 0, x = 0, y = 0, xx = 0, xy = 0;
    for (const std::int32_t k : packings) {
        const PackingTraits& traits = set.packings[static_cast<std::size_t>(k)].traits;
        const double a = std::log(traits.pressure), b = std::log(traits.*trait);
        n += 1, x += a, y += b, xx += a * a, xy += a * b;
    }
    const double spread = n * xx - x * x;
    // Equal pressures leave round-off.
    const double slope = spread > 1e-9 * n * xx ? (n * xy - x * y) / spread : 0;
    return {(y - slope * x) / n, slope};
}

}  // namespace

void withhold_traits(HistorySet& set, const std::vector<std::int64_t>& training, scene::TrainTraits known) {
    if (known == scene::TrainTraits::all) return;
    std::set<std::int32_t> seen;
    for (const std::int64_t k : training) seen.insert(set.histories[static_cast<std::size_t>(k)].packing);
    const PowerLaw bulk = fit(set, seen, &PackingTraits::bulk), shear = fit(set, seen, &PackingTraits::shear);
    for (io::HistoryPacking& packing : set.packings) {
        PackingTraits& t = packing.traits;
        t.coordination = 3.5, t.strength = 0.5, t.fabric_xx = t.fabric_xy = 0;
        if (known == scene::TrainTraits::none) t.bulk = bulk.at(t.pressure), t.shear = shear.at(t.pressure);
    }
}

}  // namespace sandgraph::training
