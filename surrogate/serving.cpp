#include "surrogate/serving.hpp"

#include "surrogate/kernel.hpp"
#include "surrogate/point_update.hpp"

namespace sandgraph::surrogate {

Serving::Serving(Model model) : kernel_(std::move(model)) {}

void Serving::start(const stress::PackingTraits& traits, const Stress& initial,
                    std::span<double> state) const {
    pack(kernel_.layout, start_point(kernel_.model, traits, initial), state);
}

void Serving::update(std::span<const std::int32_t> points, std::span<const Mat2> F_inc,
                     std::span<double> states, std::span<stress::SurrogateAnswer> answers) const {
    serve(kernel_, points, F_inc, states, answers);
}

stress::Tangent Serving::tangent(std::span<const double> state, const Eigen::Vector3d& strain) const {
    return difference_tangent(*this, state, strain);
}

}  // namespace sandgraph::surrogate
