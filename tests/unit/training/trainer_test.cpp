#include "training/trainer.hpp"

#include <gtest/gtest.h>
#include <torch/types.h>
#include <torch/utils.h>

#include <cmath>
#include <filesystem>

#include "support/random_histories.hpp"
#include "training/element_law.hpp"

namespace sandgraph::training {
namespace {

constexpr std::int64_t histories = 32;

std::shared_ptr<ElementLaw> law_of(std::uint64_t seed, std::int64_t members) {
    return std::make_shared<ElementLaw>(Rung::fitted, members, seed);
}

// Constants of elements unlike any that a law starts from.
std::shared_ptr<ElementLaw> known_law() {
    auto law = law_of(100, 1);
    const torch::NoGradGuard no_gradients;
    law->exponent.fill_(-1.2), law->log_bulk.fill_(0.2);
    law->log_strength.add_(-0.3), law->dilatancy.fill_(0.25);
    return law;
}

std::vector<Batch> measured_by(const ElementLaw& law) {
    const HistorySet set = support::random_histories(histories, 100);
    std::vector<std::int64_t> all(set.histories.size());
    std::iota(all.begin(), all.end(), 0);
    auto batches =
        make_batches(cut_all(set, all, {.most = 4e-4, .share = 0.1, .lead_from = 0, .lead_strain = 0}, 1), 16,
                     torch::kDouble);
    const torch::NoGradGuard no_gradients;
    for (Batch& batch : batches) {
        const Prediction answer = law.rollout(batch);
        batch.p = answer.p.select(1, 0).clone();
        batch.s = answer.s.select(1, 0).clone();
    }
    return batches;
}

Trainer trainer_of(const std::shared_ptr<ElementLaw>& law, int epochs, const std::string& identity = "a") {
    return Trainer(law, {.epochs = epochs, .patience = 1000, .rate = 3e-2, .rate_end = 1e-3, .scale = {}},
                   histories, identity);
}

std::vector<double> parameters_of(const ElementLaw& law) {
    std::vector<double> out;
    for (const torch::Tensor& p : law.parameters()) {
        const torch::Tensor row = p.detach().contiguous().flatten();
        out.insert(out.end(), row.data_ptr<double>(), row.data_ptr<double>() + row.numel());
    }
    return out;
}

TEST(Trainer, FindsTheConstantsThatTheDataWasMadeWith) {
    const auto truth = known_law(), law = law_of(5, 1);
    const auto data = measured_by(*truth);
    Trainer trainer = trainer_of(law, 150);
    const double first = trainer.epoch(data, data).loss;
    while (!trainer.done()) trainer.epoch(data, data);
    trainer.finish();
    EXPECT_LT(trainer.best(), 0.01 * first);
    const torch::NoGradGuard no_gradients;
    EXPECT_NEAR(law->log_bulk.exp().item<double>(), std::exp(0.2), 0.03 * std::exp(0.2));
    EXPECT_NEAR(torch::sigmoid(law->exponent).item<double>(), 1 / (1 + std::exp(1.2)), 0.03);
    const double strength = truth->log_strength.exp().sum().item<double>();
    EXPECT_NEAR(law->log_strength.exp().sum().item<double>(), strength, 0.03 * strength);
}

TEST(Trainer, RepeatsBitForBitFromItsSeed) {
    const auto data = measured_by(*known_law());
    std::vector<std::vector<double>> runs;
    for (int run = 0; run < 2; ++run) {
        const auto law = law_of(5, 2);
        Trainer trainer = trainer_of(law, 4);
        while (!trainer.done()) trainer.epoch(data, data);
        runs.push_back(parameters_of(*law));
    }
    EXPECT_EQ(runs[0], runs[1]);
}

TEST(Trainer, GoesOnFromItsStateAsIfItHadNeverStopped) {
    const auto data = measured_by(*known_law());
    const auto file = std::filesystem::path(testing::TempDir()) / "trainer_test.state";
    const auto whole = law_of(5, 2), half = law_of(5, 2), rest = law_of(6, 2);
    Trainer through = trainer_of(whole, 6), before = trainer_of(half, 6), after = trainer_of(rest, 6);
    while (!through.done()) through.epoch(data, data);
    for (int epoch = 0; epoch < 3; ++epoch) before.epoch(data, data);
    before.save(file);
    Trainer other = trainer_of(law_of(5, 2), 6, "b");
    EXPECT_FALSE(other.load(file)) << "a state of other data";
    ASSERT_TRUE(after.load(file));
    while (!after.done()) after.epoch(data, data);
    EXPECT_EQ(parameters_of(*whole), parameters_of(*rest));
    std::filesystem::remove(file);
}

}  // namespace
}  // namespace sandgraph::training
