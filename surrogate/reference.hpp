#pragma once
#include "stress/surrogate.hpp"
#include "surrogate/state_layout.hpp"

namespace sandgraph::surrogate {

// The readable truth of the element network, one point after another. The kernel agrees with it to round-off.
class Reference final : public stress::Surrogate {
  public:
    explicit Reference(Model model);
    std::size_t state_size() const override { return layout_.size(); }
    void start(const stress::PackingTraits& traits, const Stress& initial,
               std::span<double> state) const override;
    void update(std::span<const std::int32_t> points, std::span<const Mat2> F_inc, std::span<double> states,
                std::span<stress::SurrogateAnswer> answers) const override;
    stress::Tangent tangent(std::span<const double> state, const Eigen::Vector3d& strain) const override;

    const Model& model() const { return model_; }
    const StateLayout& layout() const { return layout_; }

  private:
    Model model_;
    StateLayout layout_;
};

}  // namespace sandgraph::surrogate
