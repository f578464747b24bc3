#include "packings/sand_sample.hpp"

#include <tbb/parallel_for.h>

#include <numeric>
#include <optional>

#include "packings/samples.hpp"

namespace sandgraph::packings {
namespace {

// Several are made at once and tell how many are done; one tells how far it is.
std::vector<CompressedPackings> made(const scene::Grains& grains, const ProgressCallback& progress) {
    if (grains.samples == 1) return {CompressedPackings(grains, progress)};
    std::vector<std::optional<CompressedPackings>> each(static_cast<std::size_t>(grains.samples));
    Tally tally(each.size(), progress);
    tbb::parallel_for(0, grains.samples, [&](int sample) {
        each[static_cast<std::size_t>(sample)].emplace(sample_recipe(grains, sample));
        tally.done("base packings");
    });
    std::vector<CompressedPackings> out;
    for (auto& one : each) out.push_back(*std::move(one));
    return out;
}

// f(sample) of all at once, in their order.
template <class F>
std::vector<double> of_each(std::size_t samples, F f) {
    std::vector<double> out(samples);
    tbb::parallel_for(std::size_t{0}, samples, [&](std::size_t k) { out[k] = f(k); });
    return out;
}

double mean(const std::vector<double>& values) {
    return std::accumulate(values.begin(), values.end(), 0.0) / static_cast<double>(values.size());
}

}  // namespace

SandSample::SandSample(const scene::Grains& grains, const ProgressCallback& progress)
    : packings_(made(grains, progress)) {}

double SandSample::porosity() const {
    return mean(of_each(size(), [&](std::size_t k) { return dem::porosity(packings_[k].base_packing()); }));
}

double SandSample::porosity(double pressure, double k0) const {
    return mean(of_each(size(), [&](std::size_t k) { return dem::porosity(packings_[k].at(pressure, k0)); }));
}

std::vector<double> SandSample::friction(const ProgressCallback& progress) const {
    const bool alone = size() == 1;
    Tally tally(size(), progress);
    return of_each(size(), [&](std::size_t k) {
        const double angle = packings_[k].friction(alone ? progress : ProgressCallback{});
        tally.done("friction of the base packings");
        return angle;
    });
}

}  // namespace sandgraph::packings
