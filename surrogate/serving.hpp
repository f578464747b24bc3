#pragma once
#include "stress/surrogate.hpp"
#include "surrogate/kernel_model.hpp"

namespace sandgraph::surrogate {

// The law of a model, served by the vectorised kernel.
class Serving final : public stress::Surrogate {
  public:
    explicit Serving(Model model);
    std::size_t state_size() const override { return kernel_.layout.size(); }
    void start(const stress::PackingTraits& traits, const Stress& initial,
               std::span<double> state) const override;
    void update(std::span<const std::int32_t> points, std::span<const Mat2> F_inc, std::span<double> states,
                std::span<stress::SurrogateAnswer> answers) const override;
    stress::Tangent tangent(std::span<const double> state, const Eigen::Vector3d& strain) const override;

  private:
    KernelModel kernel_;
};

}  // namespace sandgraph::surrogate
