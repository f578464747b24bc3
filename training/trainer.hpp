#pragma once
#include <torch/optim/adam.h>

#include <filesystem>
#include <string>

#include "scene/train_spec.hpp"
#include "training/law.hpp"
#include "training/loss.hpp"

namespace sandgraph::training {

using scene::TrainOptions;

struct EpochReport {
    int epoch = 0, epochs = 0;
    double loss = 0, validation = 0;  // means over the members; validation of the best parameters so far too
    double best = 0;
    double seconds_left = 0;
};

// Trains every member of a law by Adam on full-history rollouts; keeps each member's best parameters on the
// validation histories. Deterministic in options, data and parameters for a fixed number of threads.
class Trainer {
  public:
    using Batches = std::vector<Batch>;
    Trainer(std::shared_ptr<Law> law, const TrainOptions& options, std::int64_t histories,
            std::string identity);

    // One pass over the training batches in an order drawn from the seed and the epoch.
    // Validation is the mean of `validation` and, if there is any, `guard`.
    EpochReport epoch(const Batches& training, const Batches& validation, const Batches& guard = {});
    // The parameters as they are count as an epoch: training on from a good model keeps it unless it gets
    // better.
    void keep_start(const Batches& validation, const Batches& guard);
    bool done() const { return epoch_ >= options_.epochs || idle_ >= options_.patience; }
    int epochs() const { return epoch_; }
    // Puts the best parameters of every member into the law.
    void finish();

    // Atomic. Loading answers false, and leaves the trainer as it was, when there is no file or one of
    // another identity (data, recipe, law).
    void save(const std::filesystem::path& file) const;
    bool load(const std::filesystem::path& file);
    double best() const { return best_error_.mean().item<double>(); }  // validation loss, mean of the members

  private:
    double descend(const Batch& batch);
    void clip_gradients();
    torch::Tensor validate(const Batches& validation) const;
    torch::Tensor validate(const Batches& validation, const Batches& guard) const;
    void keep_better(const torch::Tensor& error);

    std::shared_ptr<Law> law_;
    TrainOptions options_;
    std::string identity_;
    torch::optim::Adam adam_;
    torch::Tensor drawn_;              // [E, histories] bootstrap
    std::vector<torch::Tensor> best_;  // parameters
    torch::Tensor best_error_;         // [E]
    int epoch_ = 0, idle_ = 0;
};

}  // namespace sandgraph::training
