#include "training/element_law.hpp"

#include <gtest/gtest.h>
#include <torch/types.h>
#include <torch/utils.h>

#include <Eigen/LU>

#include "support/random_histories.hpp"
#include "surrogate/reference.hpp"
#include "training/export_model.hpp"
#include "training/loss.hpp"

namespace sandgraph::training {
namespace {

struct Sample {
    HistorySet set = support::random_histories(20, 60);
    std::vector<Batch> batches;
    Sample() {
        std::vector<std::int64_t> all(set.histories.size());
        std::iota(all.begin(), all.end(), 0);
        batches = make_batches(cut_all(set, all, CutRule{}, 1), 100, torch::kDouble);
    }
    const Batch& batch() const { return batches.front(); }
};

std::shared_ptr<ElementLaw> law_of(Rung rung) {
    auto law = std::make_shared<ElementLaw>(rung, 3, 7);
    const torch::NoGradGuard no_gradients;
    law->W3.mul_(10);  // so that the network matters
    return law;
}

class EveryElementRung : public testing::TestWithParam<Rung> {};

TEST_P(EveryElementRung, FusedRolloutGivesTheStressesAndGradientsOfTheStepByStepOne) {
    const Sample sample;
    const auto law = law_of(GetParam());
    const auto results = [&](bool fused) {
        law->fused = fused;
        law->zero_grad();
        const Prediction prediction = law->rollout(sample.batch());
        const auto drawn = torch::ones({3, std::ssize(sample.set.histories)}, torch::kDouble);
        rollout_loss(prediction, sample.batch(), drawn, 0.1).sum().backward();
        std::vector<torch::Tensor> out = {prediction.p.detach() / 1e4, prediction.s.detach() / 1e4};
        for (const torch::Tensor& parameter : law->parameters())
            if (parameter.grad().defined()) out.push_back(parameter.grad().clone());
        return out;
    };
    const auto fused = results(true), plain = results(false);
    ASSERT_EQ(fused.size(), plain.size());
    for (std::size_t k = 0; k < fused.size(); ++k)
        EXPECT_LT((fused[k] - plain[k]).abs().max().item<double>(),
                  1e-9 * (1e-3 + plain[k].abs().max().item<double>()))
            << k;
}

// Drives the served law through the steps of a history in the frame that turns with the packing.
void expect_served_alike(const ElementLaw& law, const Sample& sample, std::int64_t b) {
    const Batch& batch = sample.batch();
    const Prediction rolled = law.rollout(batch);
    const surrogate::Reference served(export_model(law, 1));
    const io::HistoryPacking& start =
        sample.set.start_of(sample.set.histories[batch.histories[b].item<std::int64_t>()]);
    std::vector<double> state(served.state_size());
    served.start(start.traits, tension_positive(start.stress), state);
    for (std::int64_t t = 0; t < batch.steps() && batch.weight[t][b].item<double>() > 0; ++t) {
        const double dv = batch.dv[t][b].item<double>(), re = batch.de[t][b][0].item<double>(),
                     im = batch.de[t][b][1].item<double>();
        // E = 2 (U - I)(U + I)^-1, so U = (1 + E/2)(1 - E/2)^-1
        const Mat2 half = 0.5 * (Mat2() << -0.5 * dv - re, -im, -im, -0.5 * dv + re).finished();
        const Mat2 F = (Mat2::Identity() + half) * (Mat2::Identity() - half).inverse();
        const std::int32_t point = 0;
        stress::SurrogateAnswer answer;
        served.update({&point, 1}, {&F, 1}, state, {&answer, 1});
        const double p = rolled.p[t].select(1, b).mean().item<double>(), p0 = start.traits.pressure;
        const torch::Tensor s = rolled.s[t].select(1, b).mean(0) / p0;
        ASSERT_NEAR(mean_stress(answer.stress) / p0, p / p0, 1e-12 * (1 + p / p0)) << "step " << t;
        ASSERT_NEAR(deviator_of(answer.stress).real() / p0, s[0].item<double>(), 1e-12 * (1 + p / p0));
        ASSERT_NEAR(deviator_of(answer.stress).imag() / p0, s[1].item<double>(), 1e-12 * (1 + p / p0));
    }
}

TEST_P(EveryElementRung, IsServedAsItIsTrainedToTwelveDigits) {
    const Sample sample;
    const auto law = law_of(GetParam());
    set_ranges(*law, sample.batches);
    law->midpoint = true;
    const torch::NoGradGuard no_gradients;
    for (std::int64_t b = 0; b < sample.batch().size(); ++b) expect_served_alike(*law, sample, b);
}

INSTANTIATE_TEST_SUITE_P(Rungs, EveryElementRung, testing::Values(Rung::elastic, Rung::fitted, Rung::learned),
                         [](const auto& rung) { return std::string(name_of(rung.param)); });

}  // namespace
}  // namespace sandgraph::training
