#include "training/trainer.hpp"

#include <torch/serialize.h>
#include <torch/types.h>
#include <torch/utils.h>

#include <cmath>
#include <numbers>
#include <numeric>

#include "base/console.hpp"
#include "base/contracts.hpp"
#include "base/random.hpp"
#include "io/atomic_file.hpp"

namespace sandgraph::training {
namespace {

using torch::Tensor;

// How often each member draws each history, with replacement; a single member takes all.
Tensor bootstrap(std::int64_t members, std::int64_t histories, std::uint64_t seed) {
    if (members == 1) return torch::ones({1, histories}, torch::kDouble);
    Tensor drawn = torch::zeros({members, histories}, torch::kDouble);
    auto count = drawn.accessor<double, 2>();
    for (std::int64_t e = 0; e < members; ++e) {
        Random random(seed, 1000 + static_cast<std::uint64_t>(e));
        for (std::int64_t k = 0; k < histories; ++k)
            count[e][static_cast<std::int64_t>(random.uniform(0, static_cast<double>(histories)))] += 1;
    }
    return drawn;
}

std::vector<std::size_t> shuffled(std::size_t count, std::uint64_t seed, int epoch) {
    std::vector<std::size_t> order(count);
    std::iota(order.begin(), order.end(), std::size_t{0});
    Random random(seed, static_cast<std::uint64_t>(epoch));
    for (std::size_t k = count; k > 1; --k)
        std::swap(order[k - 1], order[static_cast<std::size_t>(random.uniform(0, static_cast<double>(k)))]);
    return order;
}

}  // namespace

Trainer::Trainer(std::shared_ptr<Law> law, const TrainOptions& options, std::int64_t histories,
                 std::string identity)
    : law_(std::move(law)),
      options_(options),
      identity_(std::move(identity)),
      adam_(law_->parameters(), torch::optim::AdamOptions(options.rate)),
      drawn_(bootstrap(law_->members(), histories, options.seed)),
      best_error_(torch::full(law_->members(), std::numeric_limits<double>::infinity(), torch::kDouble)) {
    SG_EXPECT(histories > 0 && options.epochs > 0 && options.rate > 0);
    for (const Tensor& parameter : law_->parameters()) best_.push_back(parameter.detach().clone());
    drawn_ = drawn_.to(law_->parameters().front().dtype());
}

// By member, so that one that has gone astray cannot hold the others back. A gradient that is not finite
// counts as none.
void Trainer::clip_gradients() {
    Tensor squares = torch::zeros(law_->members(), law_->parameters().front().options());
    for (const Tensor& parameter : law_->parameters())
        if (parameter.grad().defined())
            squares += parameter.grad().reshape({law_->members(), -1}).square().sum(1);
    const Tensor scale = (options_.clip / (squares.sqrt() + 1e-12)).clamp_max(1);
    for (Tensor& parameter : law_->parameters()) {
        if (!parameter.grad().defined()) continue;
        std::vector<std::int64_t> shape(parameter.dim(), 1);
        shape[0] = -1;
        Tensor& gradient = parameter.mutable_grad();
        gradient = torch::nan_to_num(gradient * scale.reshape(shape), 0.0, 0.0, 0.0);
    }
}

double Trainer::descend(const Batch& batch) {
    adam_.zero_grad();
    const Tensor loss = rollout_loss(law_->rollout(batch), batch, drawn_, options_.scale);
    loss.sum().backward();
    clip_gradients();
    adam_.step();
    return loss.mean().item<double>();
}

// Mean loss of each member on histories it is not trained on [E].
Tensor Trainer::validate(const Batches& validation) const {
    const torch::NoGradGuard no_gradients;
    Tensor sum = torch::zeros(law_->members(), torch::kDouble);
    double weight = 0;
    const Tensor all = torch::ones_like(drawn_);
    for (const Batch& batch : validation) {
        const double steps = batch.weight.sum().item<double>();
        sum += steps * rollout_loss(law_->rollout(batch), batch, all, options_.scale).to(torch::kDouble);
        weight += steps;
    }
    return torch::nan_to_num(sum / weight, 1e9, 1e9, 1e9);
}

void Trainer::keep_better(const Tensor& error) {
    const torch::NoGradGuard no_gradients;
    const Tensor better = error < best_error_;
    idle_ = better.any().item<bool>() ? 0 : idle_ + 1;
    best_error_ = torch::minimum(error, best_error_);
    const std::vector<Tensor> now = law_->parameters();
    for (std::size_t k = 0; k < now.size(); ++k) {
        std::vector<std::int64_t> shape(now[k].dim(), 1);
        shape[0] = -1;
        best_[k] = torch::where(better.reshape(shape), now[k], best_[k]).clone();
    }
}

torch::Tensor Trainer::validate(const Batches& validation, const Batches& guard) const {
    return guard.empty() ? validate(validation) : 0.5 * (validate(validation) + validate(guard));
}

void Trainer::keep_start(const Batches& validation, const Batches& guard) {
    keep_better(validate(validation, guard));
}

EpochReport Trainer::epoch(const Batches& training, const Batches& validation, const Batches& guard) {
    SG_EXPECT(!training.empty() && !validation.empty());
    const double start = wall_clock();
    const double turn = std::numbers::pi * epoch_ / std::max(1, options_.epochs - 1);
    const double rate = options_.rate_end + 0.5 * (options_.rate - options_.rate_end) * (1 + std::cos(turn));
    for (auto& group : adam_.param_groups())
        static_cast<torch::optim::AdamOptions&>(group.options()).lr(rate);
    EpochReport report{.epoch = ++epoch_, .epochs = options_.epochs};
    for (const std::size_t k : shuffled(training.size(), options_.seed, epoch_))
        report.loss += descend(training[k]) / static_cast<double>(training.size());
    const Tensor error = validate(validation, guard);
    keep_better(error);
    report.validation = error.mean().item<double>();
    report.best = best_error_.mean().item<double>();
    report.seconds_left = (wall_clock() - start) * (options_.epochs - epoch_);
    return report;
}

void Trainer::finish() {
    const torch::NoGradGuard no_gradients;
    std::vector<Tensor> now = law_->parameters();
    for (std::size_t k = 0; k < now.size(); ++k) now[k].copy_(best_[k]);
}

// Parameters of the law and the running means of Adam, which torch numbers alike.
void Trainer::save(const std::filesystem::path& file) const {
    torch::serialize::OutputArchive archive, law, adam;
    law_->save(law);
    adam_.save(adam);
    archive.write("law", law);
    archive.write("adam", adam);
    for (std::size_t k = 0; k < best_.size(); ++k) archive.write("best" + std::to_string(k), best_[k], true);
    archive.write("best_error", best_error_, true);
    archive.write("progress", torch::tensor({epoch_, idle_}, torch::kLong), true);
    archive.write("identity", c10::IValue(identity_));
    io::AtomicFile target(file);
    archive.save_to(target.temporary().string());
    target.commit();
}

bool Trainer::load(const std::filesystem::path& file) {
    if (!std::filesystem::exists(file)) return false;
    torch::serialize::InputArchive archive, law, adam;
    archive.load_from(file.string());
    c10::IValue identity;
    if (!archive.try_read("identity", identity) || identity.toStringRef() != identity_) return false;
    archive.read("law", law);
    law_->load(law);
    archive.read("adam", adam);
    adam_.load(adam);
    for (std::size_t k = 0; k < best_.size(); ++k) archive.read("best" + std::to_string(k), best_[k], true);
    archive.read("best_error", best_error_, true);
    Tensor progress;
    archive.read("progress", progress, true);
    epoch_ = static_cast<int>(progress[0].item<std::int64_t>());
    idle_ = static_cast<int>(progress[1].item<std::int64_t>());
    return true;
}

}  // namespace sandgraph::training
