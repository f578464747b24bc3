#include "training/batch.hpp"

#include <algorithm>
#include <functional>

#include "base/contracts.hpp"

namespace sandgraph::training {
namespace {

using Complex = std::complex<double>;

// value(step, history) of every step; padding repeats what `padding` says of the last step.
torch::Tensor steps_of(std::span<const CutHistory> histories, std::size_t length,
                       const std::function<double(const Step&)>& value, bool pad_with_last) {
    torch::Tensor out = torch::zeros(
        {static_cast<std::int64_t>(length), static_cast<std::int64_t>(histories.size())}, torch::kDouble);
    auto a = out.accessor<double, 2>();
    for (std::size_t b = 0; b < histories.size(); ++b) {
        const std::vector<Step>& steps = histories[b].steps;
        for (std::size_t t = 0; t < length; ++t)
            if (t < steps.size() || pad_with_last) a[t][b] = value(steps[std::min(t, steps.size() - 1)]);
    }
    return out;
}

torch::Tensor packing_value(std::span<const CutHistory> histories,
                            const std::function<double(const io::HistoryPacking&)>& value) {
    std::vector<double> out;
    for (const CutHistory& h : histories) out.push_back(value(*h.start));
    return torch::tensor(out, torch::kDouble);
}

torch::Tensor complex_steps(std::span<const CutHistory> histories, std::size_t length, Complex Step::*member,
                            bool pad) {
    const auto re = steps_of(
        histories, length, [&](const Step& s) { return (s.*member).real(); }, pad);
    const auto im = steps_of(
        histories, length, [&](const Step& s) { return (s.*member).imag(); }, pad);
    return torch::stack({re, im}, 2);
}

torch::Tensor complex_constant(std::span<const CutHistory> histories,
                               const std::function<Complex(const io::HistoryPacking&)>& value) {
    const auto re = packing_value(histories, [&](const io::HistoryPacking& p) { return value(p).real(); });
    const auto im = packing_value(histories, [&](const io::HistoryPacking& p) { return value(p).imag(); });
    return torch::stack({re, im}, 1);
}

void fill_steps(Batch& batch, std::span<const CutHistory> histories, std::size_t length) {
    batch.dv = steps_of(
        histories, length, [](const Step& s) { return s.dv; }, false);
    batch.J = steps_of(
        histories, length, [](const Step& s) { return s.J; }, true);
    batch.J_middle = steps_of(
        histories, length, [](const Step& s) { return s.J_middle; }, true);
    batch.strain = steps_of(
        histories, length, [](const Step& s) { return s.strain; }, true);
    batch.p = steps_of(
        histories, length, [](const Step& s) { return s.p; }, true);
    batch.weight = steps_of(
        histories, length, [](const Step& s) { return s.weight; }, false);
    batch.lead = steps_of(
        histories, length, [](const Step& s) { return s.lead; }, false);
    batch.de = complex_steps(histories, length, &Step::de, false);
    batch.s = complex_steps(histories, length, &Step::s, true);
}

void fill_constants(Batch& batch, std::span<const CutHistory> histories) {
    const auto of = [&](double stress::PackingTraits::*trait) {
        return packing_value(histories, [&](const io::HistoryPacking& p) { return p.traits.*trait; });
    };
    using stress::PackingTraits;
    batch.p0 = of(&PackingTraits::pressure);
    batch.K0 = of(&PackingTraits::bulk);
    batch.G0 = of(&PackingTraits::shear);
    batch.Z0 = of(&PackingTraits::coordination);
    batch.sin_phi = of(&PackingTraits::peak_friction);
    const torch::Tensor n = of(&PackingTraits::porosity);
    batch.e0 = n / (1 - n);
    batch.fabric = torch::stack({of(&PackingTraits::fabric_xx), of(&PackingTraits::fabric_xy)}, 1);
    batch.s0 = complex_constant(
        histories, [](const io::HistoryPacking& p) { return deviator_of(tension_positive(p.stress)); });
}

}  // namespace

Batch make_batch(std::span<const CutHistory> histories, torch::Dtype type) {
    SG_EXPECT(!histories.empty());
    SG_EXPECT(
        std::ranges::all_of(histories, [](const CutHistory& h) { return h.start && !h.steps.empty(); }));
    std::size_t length = 0;
    for (const CutHistory& h : histories) length = std::max(length, h.steps.size());
    Batch batch;
    fill_steps(batch, histories, length);
    fill_constants(batch, histories);
    for (torch::Tensor* t : {&batch.dv, &batch.J, &batch.J_middle, &batch.strain, &batch.de, &batch.p,
                             &batch.s, &batch.weight, &batch.lead, &batch.p0, &batch.e0, &batch.K0, &batch.G0,
                             &batch.Z0, &batch.sin_phi, &batch.fabric, &batch.s0})
        *t = t->to(type).contiguous();
    std::vector<std::int64_t> index;
    for (const CutHistory& h : histories) index.push_back(h.index);
    batch.histories = torch::tensor(index, torch::kLong);
    return batch;
}

std::vector<CutHistory> cut_all(const HistorySet& set, std::span<const std::int64_t> which,
                                const CutRule& rule, double strain_max) {
    SG_EXPECT(all_below(which, set.histories.size()));
    std::vector<CutHistory> out;
    for (const std::int64_t k : which) {
        const History& history = set.histories[k];
        CutHistory one{k, &set.start_of(history), cut(history, rule)};
        std::erase_if(one.steps, [&](const Step& s) { return s.strain > strain_max; });
        if (!one.steps.empty()) out.push_back(std::move(one));
    }
    return out;
}

std::vector<Batch> make_batches(std::vector<CutHistory> histories, std::size_t size, torch::Dtype type) {
    SG_EXPECT(size > 0);
    std::ranges::stable_sort(histories, {}, [](const CutHistory& h) { return h.steps.size(); });
    std::vector<Batch> batches;
    const std::span<const CutHistory> all(histories);
    for (std::size_t k = 0; k < all.size(); k += size)
        batches.push_back(make_batch(all.subspan(k, std::min(size, all.size() - k)), type));
    return batches;
}

}  // namespace sandgraph::training
