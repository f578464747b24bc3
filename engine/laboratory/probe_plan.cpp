#include "laboratory/probe_plan.hpp"

#include <cmath>
#include <numbers>
#include <numeric>

#include "scene/grain_keys.hpp"

namespace sandgraph::laboratory {
namespace {

using io::HistoryPath;
using io::HistoryTwin;

// Streams of the plan's random numbers, apart from those of the paths (one a history).
constexpr std::uint64_t kOrder = 1ull << 40, kDeal = 2ull << 40, kPressures = 3ull << 40, kTwins = 4ull << 40;

template <class T>
void shuffle(std::vector<T>& values, Random& random) {
    for (std::size_t k = values.size(); k > 1; --k)
        std::swap(values[k - 1], values[static_cast<std::size_t>(random.uniform() * static_cast<double>(k))]);
}

// The kinds of all histories in random order.
std::vector<HistoryPath> kinds(const scene::ProbeSpec& spec) {
    const scene::ProbePaths& p = spec.paths;
    std::vector<HistoryPath> out;
    const auto add = [&out](HistoryPath kind, int count) { out.insert(out.end(), count, kind); };
    add(HistoryPath::proportional, p.proportional), add(HistoryPath::constant_volume, p.constant_volume);
    add(HistoryPath::constant_pressure, p.constant_pressure), add(HistoryPath::cyclic, p.cyclic);
    add(HistoryPath::dither, p.dither), add(HistoryPath::rotating, p.rotating),
        add(HistoryPath::mixed, p.mixed), add(HistoryPath::critical_shear, p.flow);
    Random random(spec.seed, kOrder);
    shuffle(out, random);
    return out;
}

// The same for every seed, so that a twin on another seed starts at the same pressure.
std::vector<double> pressures(const scene::ProbeSpec& spec, std::size_t density) {
    const scene::ProbePackings& p = spec.packings;
    Random random(spec.seed, kPressures + density);
    std::vector<double> out;
    for (int k = 0; k < p.pressures; ++k)
        out.push_back(p.pressure_min *
                      std::pow(p.pressure_max / p.pressure_min, (k + random.uniform()) / p.pressures));
    return out;
}

std::vector<PackingPlan> plan_packings(const scene::ProbeSpec& spec) {
    std::vector<PackingPlan> out;
    for (std::size_t density = 0; density < spec.packings.porosities.size(); ++density)
        for (int seed = 0; seed < spec.packings.seeds; ++seed)
            for (const double pressure : pressures(spec, density)) {
                PackingPlan packing{spec.grains, pressure};
                packing.grains.seed = static_cast<std::uint64_t>(spec.packings.first_seed + seed);
                packing.grains.target_porosity = spec.packings.porosities[density];
                packing.grains.density = scene::density_name(packing.grains.target_porosity);
                out.push_back(packing);
            }
    return out;
}

// Deals packings to histories: each comes once before any comes again.
class Dealer {
  public:
    Dealer(std::size_t packings, std::uint64_t seed) : order_(packings), random_(seed, kDeal) {
        std::iota(order_.begin(), order_.end(), 0);
    }
    std::int32_t deal() {
        if (next_ == 0) shuffle(order_, random_);
        const std::int32_t out = order_[next_];
        next_ = (next_ + 1) % order_.size();
        return out;
    }

  private:
    std::vector<std::int32_t> order_;
    std::size_t next_ = 0;
    Random random_;
};

// The packing of the next seed, of the same porosity and pressure.
std::int32_t neighbour(std::int32_t packing, const scene::ProbePackings& p) {
    const int row = packing / p.pressures, seed = row % p.seeds;
    return packing + ((seed + 1) % p.seeds - seed) * p.pressures;
}

void add_twins(const scene::ProbeSpec& spec, ProbePlan& plan, ProbeJob& job) {
    const auto original = static_cast<std::int32_t>(job.first);
    const auto add = [&](HistoryTwin twin) -> io::HistoryInfo& {
        io::HistoryInfo info = plan.histories[job.first];
        info.twin = twin, info.twin_of = original;
        ++job.count;
        return plan.histories.emplace_back(info);
    };
    if (spec.packings.seeds > 1) {
        io::HistoryInfo& other = add(HistoryTwin::other_seed);
        other.packing = neighbour(other.packing, spec.packings);
    }
    Random random(spec.seed, kTwins + job.first);
    add(HistoryTwin::rotated).rotation = random.uniform(0, std::numbers::pi);
    add(HistoryTwin::finer), add(HistoryTwin::coarser);
}

}  // namespace

ProbePlan plan_probe(const scene::ProbeSpec& spec) {
    ProbePlan plan;
    plan.packings = plan_packings(spec);
    Dealer dealer(plan.packings.size(), spec.seed);
    const int every = spec.paths.twin_every;
    for (const HistoryPath kind : kinds(spec)) {
        ProbeJob job{plan.histories.size(), 1, draw_path(kind, spec, plan.jobs.size())};
        io::HistoryInfo info;
        info.packing = dealer.deal(), info.path = kind;
        plan.histories.push_back(info);
        if (every > 0 && plan.jobs.size() % static_cast<std::size_t>(every) == 0) add_twins(spec, plan, job);
        plan.jobs.push_back(std::move(job));
    }
    return plan;
}

}  // namespace sandgraph::laboratory
