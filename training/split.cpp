#include "training/split.hpp"

#include <fmt/format.h>

#include <algorithm>
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

}  // namespace sandgraph::training
