#include "training/evaluate.hpp"

#include <torch/types.h>
#include <torch/utils.h>

#include <algorithm>
#include <cmath>

#include "base/contracts.hpp"
#include "stress/increment.hpp"
#include "training/loss.hpp"

namespace sandgraph::training {
namespace {

void add_samples(const Law& law, const Batch& batch, std::vector<ErrorSample>& samples) {
    const auto plain = [](const torch::Tensor& t) { return t.to(torch::kDouble).contiguous(); };
    const Prediction rolled = law.rollout(batch);
    const torch::Tensor scale = batch.p.clamp_min(1e3);
    const torch::Tensor error = plain(ensemble_error(rolled, batch)),
                        p = plain((rolled.p.mean(1) - batch.p) / scale),
                        q = plain((rolled.s.mean(1).norm(2, 2) - batch.s.norm(2, 2)) / scale);
    const torch::Tensor strain = plain(batch.strain), weight = plain(batch.weight);
    const auto e = error.accessor<double, 2>(), l = strain.accessor<double, 2>(),
               w = weight.accessor<double, 2>(), dp = p.accessor<double, 2>(), dq = q.accessor<double, 2>();
    const auto history = batch.histories.accessor<std::int64_t, 1>();
    for (std::int64_t b = 0; b < batch.size(); ++b)
        for (std::int64_t t = 0; t < batch.steps(); ++t)
            if (w[t][b] > 0) samples.push_back({history[b], l[t][b], e[t][b], dp[t][b], dq[t][b]});
}

// Every `count` increments of a history composed to one.
History joined(const History& history, std::size_t count) {
    SG_EXPECT(count > 0 && history.F_inc.size() == history.stress.size());
    History out = history;
    out.F_inc.clear();
    out.stress.clear();
    for (std::size_t row = 0; row + count <= history.F_inc.size(); row += count) {
        Mat2 F = Mat2::Identity();
        for (std::size_t k = 0; k < count; ++k) F = history.F_inc[row + k] * F;
        out.F_inc.push_back(F);
        out.stress.push_back(history.stress[row + count - 1]);
    }
    return out;
}

struct Pair {
    History original, twin;  // equal increments
};

Pair aligned(const HistorySet& set, const History& twin) {
    constexpr std::size_t ten = 10;
    Pair pair{set.histories[twin.twin_of], twin};
    if (twin.info.twin == io::HistoryTwin::finer) pair.twin = joined(twin, ten);
    if (twin.info.twin == io::HistoryTwin::coarser) pair.original = joined(pair.original, ten);
    const double c = std::cos(twin.info.rotation), s = -std::sin(twin.info.rotation);
    for (Stress& stress : pair.twin.stress) stress = stress::rotate(stress, c, s);
    const std::size_t rows = std::min(pair.original.F_inc.size(), pair.twin.F_inc.size());
    for (History* h : {&pair.original, &pair.twin}) h->F_inc.resize(rows), h->stress.resize(rows);
    pair.twin.F_inc = pair.original.F_inc;
    return pair;
}

void add_twin_samples(const HistorySet& set, std::int64_t index, const CutRule& rule, double strain_max,
                      std::vector<ErrorSample>& samples) {
    const Pair pair = aligned(set, set.histories[index]);
    const std::vector<Step> a = cut(pair.original, rule), b = cut(pair.twin, rule);
    for (std::size_t k = 0; k < a.size() && a[k].strain <= strain_max; ++k) {
        const double squared = 2 * std::pow(a[k].p - b[k].p, 2) + 2 * std::norm(a[k].s - b[k].s);
        const double scale = std::max(a[k].p, 1e3);
        samples.push_back({index, a[k].strain, std::sqrt(squared) / scale, (b[k].p - a[k].p) / scale,
                           (std::abs(b[k].s) - std::abs(a[k].s)) / scale});
    }
}

}  // namespace

std::vector<ErrorSample> evaluate(const Law& law, std::span<const Batch> batches) {
    const torch::NoGradGuard no_gradients;
    std::vector<ErrorSample> samples;
    for (const Batch& batch : batches) add_samples(law, batch, samples);
    return samples;
}

std::vector<ErrorTable> noise_floor(const HistorySet& set, const CutRule& rule, double strain_max) {
    std::map<io::HistoryTwin, std::vector<ErrorSample>> samples;
    for (std::int64_t k = 0; k < std::ssize(set.histories); ++k)
        if (const History& h = set.histories[k]; h.twin_of >= 0)
            add_twin_samples(set, k, rule, strain_max, samples[h.info.twin]);
    std::vector<ErrorTable> tables;
    for (const auto& [twin, list] : samples)
        tables.push_back({std::string("DEM twin ") + io::name(twin), "its original", error_rows(set, list)});
    return tables;
}

}  // namespace sandgraph::training
