#pragma once
#include <functional>
#include <memory>

#include "stress/surrogate.hpp"

namespace sandgraph::stability {

// A surrogate whose answers somebody changes after they are given: what it says of itself, or the stress.
class TamperedSurrogate : public stress::Surrogate {
  public:
    using Tamper = std::function<void(std::int32_t point, stress::SurrogateAnswer& answer)>;
    TamperedSurrogate(std::shared_ptr<const stress::Surrogate> honest, Tamper tamper)
        : honest_(std::move(honest)), tamper_(std::move(tamper)) {}

    std::size_t state_size() const override { return honest_->state_size(); }
    void start(const stress::PackingTraits& traits, const Stress& initial,
               std::span<double> state) const override {
        honest_->start(traits, initial, state);
    }
    void update(std::span<const std::int32_t> points, std::span<const Mat2> F_inc, std::span<double> states,
                std::span<stress::SurrogateAnswer> answers) const override {
        honest_->update(points, F_inc, states, answers);
        for (std::size_t k = 0; k < points.size(); ++k) tamper_(points[k], answers[k]);
    }
    stress::Tangent tangent(std::span<const double> state, const Eigen::Vector3d& strain) const override {
        return honest_->tangent(state, strain);
    }

  private:
    std::shared_ptr<const stress::Surrogate> honest_;
    Tamper tamper_;
};

}  // namespace sandgraph::stability
