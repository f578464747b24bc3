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

std::set<std::int64_t> seeds_of(const HistorySet& set, Origin origin) {
    std::set<std::int64_t> seeds;
    for (const History& h : set.histories)
        if (h.origin == origin) seeds.insert(set.start_of(h).seed);
    return seeds;
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

void keep_seeds(const HistorySet& set, const scene::TrainSpec& spec, Split& split) {
    const std::set<std::int64_t> runs = seeds_of(set, Origin::run), probes = seeds_of(set, Origin::probe);
    std::vector<std::int64_t> seeds(probes.begin(), probes.end());
    std::erase_if(seeds, [&](std::int64_t seed) { return runs.contains(seed); });
    std::size_t all = seeds.size() + runs.size();
    if (probes.empty() && spec.seeds_asked) seeds.assign(runs.begin(), runs.end());
    const auto wanted = static_cast<std::size_t>(spec.held_out_seeds + spec.validation_seeds);
    if (wanted <= seeds.size() && wanted < all) {
        split.seeds_held_out = take(seeds, spec.held_out_seeds);
        split.seeds_validation = take(seeds, spec.validation_seeds);
    } else if (spec.seeds_asked) {
        throw InputError({spec.file}, fmt::format("{} packing seeds in the logs", all),
                         fmt::format("{} to hold out, {} to validate, one at least to train on",
                                     spec.held_out_seeds, spec.validation_seeds),
                         "probe more seeds, or leave both keys out: histories are then held out");
    }
}

// Deals histories of seeds that are trained on: `every` so-manieth is held out, and one between two of those
// validates where no seed does.
void deal(const std::vector<std::int64_t>& histories, const scene::TrainSpec& spec, Split& split) {
    const bool validates = split.seeds_validation.empty();
    std::size_t every = static_cast<std::size_t>(spec.held_out_every);
    if (split.seeds_held_out.empty() || validates)
        every = std::min(every > 0 ? every : 10, std::max<std::size_t>(3, histories.size() / 4));
    for (std::size_t k = 0; k < histories.size(); ++k) {
        const std::size_t place = every > 0 ? (k + 1) % every : 1;
        const bool held_out = spec.held_out_every > 0 && place == 0;
        const bool validation = validates && place == every / 2;
        (held_out     ? split.known_seeds
         : validation ? split.validation
                      : split.training)
            .push_back(histories[k]);
    }
    const bool measured = spec.held_out_every == 0 || !split.known_seeds.empty() || !split.new_seeds.empty();
    if (measured && !split.training.empty() && !split.validation.empty()) return;
    throw InputError({spec.file}, fmt::format("{} histories to train on", histories.size()),
                     "three at least: one to train on, one to choose the epoch by, one to measure on",
                     "log more points of the run (output.history_points), or add logs");
}

}  // namespace

Split split(const HistorySet& set, const scene::TrainSpec& spec) {
    Split split;
    keep_seeds(set, spec, split);
    std::vector<std::int64_t> others;
    for (std::int64_t k = 0, guards = 0; k < std::ssize(set.histories); ++k) {
        const History& h = set.histories[k];
        if (h.info.twin != io::HistoryTwin::none || h.F_inc.size() < rows_least) continue;
        const std::int64_t seed = set.start_of(h).seed;
        if (h.origin == Origin::guard)
            (guards++ % 2 == 0 ? split.guard_validation : split.guard).push_back(k);
        else if (holds(split.seeds_held_out, seed))
            split.new_seeds.push_back(k);
        else if (holds(split.seeds_validation, seed))
            split.validation.push_back(k);
        else
            others.push_back(k);
    }
    deal(others, spec, split);
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
