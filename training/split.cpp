#include "training/split.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "base/contracts.hpp"
#include "base/error.hpp"

namespace sandgraph::training {
namespace {

constexpr std::size_t rows_least = 5;

std::vector<std::int64_t> seeds_of(const HistorySet& set) {
    std::set<std::int64_t> seeds;
    for (const History& h : set.histories) seeds.insert(set.start_of(h).seed);
    return {seeds.begin(), seeds.end()};
}

bool holds(const std::vector<std::int64_t>& values, std::int64_t value) {
    return std::ranges::find(values, value) != values.end();
}

// The last `count` of `seeds`, taken away from it.
std::vector<std::int64_t> take(std::vector<std::int64_t>& seeds, int count) {
    SG_EXPECT(count >= 0);
    const auto begin = seeds.end() - std::min<std::ptrdiff_t>(count, std::ssize(seeds));
    std::vector<std::int64_t> taken(begin, seeds.end());
    seeds.erase(begin, seeds.end());
    return taken;
}

// `count` of them, evenly spaced.
void thin_out(std::vector<std::int64_t>& histories, std::size_t count) {
    if (count == 0 || histories.size() <= count) return;
    std::vector<std::int64_t> kept;
    for (std::size_t k = 0; k < count; ++k) kept.push_back(histories[k * histories.size() / count]);
    histories = std::move(kept);
}

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

Split split(const HistorySet& set, const scene::TrainSpec& spec) {
    std::vector<std::int64_t> seeds = seeds_of(set);
    const std::size_t all = seeds.size();
    Split split;
    split.seeds_held_out = take(seeds, spec.held_out_seeds);
    split.seeds_validation = take(seeds, spec.validation_seeds);
    if (seeds.empty())
        throw InputError({spec.file}, fmt::format("{} packing seeds in the logs", all),
                         fmt::format("{} to hold out, {} to validate, one at least to train on",
                                     spec.held_out_seeds, spec.validation_seeds),
                         "probe more seeds, or lower held_out_seeds");
    std::int64_t counted = 0;
    for (std::int64_t k = 0; k < std::ssize(set.histories); ++k) {
        const History& h = set.histories[k];
        if (h.info.twin != io::HistoryTwin::none || h.F_inc.size() < rows_least) continue;
        const std::int64_t seed = set.start_of(h).seed;
        if (holds(split.seeds_held_out, seed))
            split.new_seeds.push_back(k);
        else if (holds(split.seeds_validation, seed))
            split.validation.push_back(k);
        else if (spec.held_out_every > 0 && ++counted % spec.held_out_every == 0)
            split.known_seeds.push_back(k);
        else
            split.training.push_back(k);
    }
    thin_out(split.training, static_cast<std::size_t>(spec.histories));
    SG_ENSURE(distinct_below(split.training, set.histories.size()));
    return split;
}

void withhold_traits(HistorySet& set, const std::vector<std::int64_t>& training, scene::TrainTraits known) {
    if (known == scene::TrainTraits::all) return;
    std::set<std::int32_t> seen;
    for (const std::int64_t k : training) seen.insert(set.histories[static_cast<std::size_t>(k)].packing);
    const PowerLaw bulk = fit(set, seen, &PackingTraits::bulk), shear = fit(set, seen, &PackingTraits::shear);
    for (io::HistoryPacking& packing : set.packings) {
        PackingTraits& t = packing.traits;
        t.coordination = 3.5, t.peak_friction = 0.5, t.fabric_xx = t.fabric_xy = 0;
        if (known == scene::TrainTraits::none) t.bulk = bulk.at(t.pressure), t.shear = shear.at(t.pressure);
    }
}

}  // namespace sandgraph::training
