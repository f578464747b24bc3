#include "training/element_law.hpp"

#include <gtest/gtest.h>
#include <torch/types.h>
#include <torch/utils.h>

#include "stress/increment.hpp"
#include "support/random_histories.hpp"
#include "surrogate/reference.hpp"
#include "training/loss.hpp"

namespace sandgraph::training {
namespace {

struct Sample {
    HistorySet set = support::random_histories(20, 60);
    std::vector<Batch> batches;
    explicit Sample(const CutRule& rule = {
                        .most = 4e-4, .share = 0.06, .lead_from = 1e-3, .lead_strain = 1e-3}) {
        std::vector<std::int64_t> all(set.histories.size());
        std::iota(all.begin(), all.end(), 0);
        batches = make_batches(cut_all(set, all, rule, 1), 100, torch::kDouble);
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
    Sample sample;
    sample.batches.front().s0.zero_();  // where the gradient is the whole gradient
    const auto law = law_of(GetParam());
    const auto results = [&](bool fused) {
        law->fused = fused;
        law->zero_grad();
        const Prediction prediction = law->rollout(sample.batch());
        const auto drawn = torch::ones({3, std::ssize(sample.set.histories)}, torch::kDouble);
        rollout_loss(prediction, sample.batch(), drawn, {.robust = 0.1, .change = 0.3}).sum().backward();
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

// Drives the served law through a history whose every increment is a step.
void expect_served_alike(const ElementLaw& law, const Sample& sample, std::int64_t b) {
    const Batch& batch = sample.batch();
    const Prediction rolled = law.rollout(batch);
    const surrogate::Reference served(*law.served(1));
    const History& history = sample.set.histories[batch.histories[b].item<std::int64_t>()];
    const io::HistoryPacking& start = sample.set.start_of(history);
    std::vector<double> state(served.state_size());
    served.start(start.traits, tension_positive(start.stress), state);
    const double p0 = start.traits.pressure;
    double angle = 0;
    for (std::int64_t t = 0; t < std::ssize(history.F_inc); ++t) {
        const std::int32_t point = 0;
        stress::SurrogateAnswer answer;
        served.update({&point, 1}, {&history.F_inc[t], 1}, state, {&answer, 1});
        const stress::Increment E = stress::increment(history.F_inc[t]);
        angle += std::atan2(E.sin, E.cos);
        const std::complex<double> s = deviator_of(answer.stress) * std::polar(1.0, -2 * angle) / p0;
        const torch::Tensor mean = rolled.s[t].select(1, b).mean(0) / p0;
        const double p = rolled.p[t].select(1, b).mean().item<double>() / p0, tolerance = 1e-12 * (1 + p);
        ASSERT_NEAR(mean_stress(answer.stress) / p0, p, tolerance) << "step " << t;
        ASSERT_NEAR(s.real(), mean[0].item<double>(), tolerance) << "step " << t;
        ASSERT_NEAR(s.imag(), mean[1].item<double>(), tolerance) << "step " << t;
    }
}

TEST_P(EveryElementRung, IsServedAsItIsTrainedToTwelveDigits) {
    const Sample sample({.least = 0, .most = 4e-4, .share = 0, .lead_from = 0, .lead_strain = 0});
    const auto law = law_of(GetParam());
    law->learn_ranges(sample.batches);
    law->midpoint = true;
    const torch::NoGradGuard no_gradients;
    for (std::int64_t b = 0; b < sample.batch().size(); ++b) expect_served_alike(*law, sample, b);
}

TEST(ElementLaw, GoesOnFromAServedModelAsItWas) {
    const auto first = law_of(Rung::learned), second = std::make_shared<ElementLaw>(Rung::learned, 3, 8);
    second->start_from(*first->served(1e-4), "model.h5");
    const Sample sample;
    const torch::NoGradGuard no_gradients;
    const Prediction a = first->rollout(sample.batch()), b = second->rollout(sample.batch());
    EXPECT_LT(((a.p - b.p) / a.p).abs().max().item<double>(), 1e-10);
    EXPECT_LT(((a.s - b.s).norm(2, 3) / a.p).abs().max().item<double>(), 1e-10);
    EXPECT_THROW(std::make_shared<ElementLaw>(Rung::learned, 2, 8)->start_from(*first->served(1e-4), "m.h5"),
                 InputError);
}

TEST(ElementLaw, KeepsTheMeasuredCriticalStateWhereItIsTold) {
    const auto law = law_of(Rung::learned);
    const torch::NoGradGuard no_gradients;
    law->critical.add_(1);
    const surrogate::CriticalState measured;
    EXPECT_GT(law->served(1e-4)->members[0].critical.void_ratio, measured.void_ratio + 0.01);
    law->measured_critical = true;
    const surrogate::Model model = *law->served(1e-4);
    for (const surrogate::Member& m : model.members) {
        EXPECT_DOUBLE_EQ(m.critical.void_ratio, measured.void_ratio);
        EXPECT_DOUBLE_EQ(m.critical.slope, measured.slope);
    }
}

// At half the measured p, half the deviator is the right friction, the whole one twice too much.
TEST(RolloutLoss, OfFrictionForgivesTheDeviatorOfALowPressure) {
    const Sample sample;
    const Batch& batch = sample.batch();
    const torch::Tensor p = batch.p.unsqueeze(1), s = batch.s.unsqueeze(1);
    const torch::Tensor drawn =
        torch::ones({1, static_cast<std::int64_t>(sample.set.histories.size())}, torch::kDouble);
    const auto loss = [&](const torch::Tensor& deviator, bool friction) {
        const LossScale scale{.friction = friction};
        return rollout_loss({0.5 * p, deviator, {}}, batch, drawn, scale).item<double>();
    };
    EXPECT_LT(loss(0.5 * s, true), loss(s, true));
    EXPECT_LT(loss(s, false), loss(0.5 * s, false));
    EXPECT_NEAR(loss(0.5 * s, true), loss(s, false), 1e-12);
}

INSTANTIATE_TEST_SUITE_P(Rungs, EveryElementRung, testing::Values(Rung::elastic, Rung::fitted, Rung::learned),
                         [](const auto& rung) { return std::string(name_of(rung.param)); });

}  // namespace
}  // namespace sandgraph::training
