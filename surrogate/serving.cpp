#include "surrogate/serving.hpp"

#include "surrogate/kernel.hpp"
#include "surrogate/point_update.hpp"
#include "surrogate/tangent.hpp"

namespace sandgraph::surrogate {

Serving::Serving(Model model) : model_(std::move(model)), layout_{model_.elements, model_.members.size()} {}

void Serving::start(const stress::PackingTraits& traits, const Stress& initial,
                    std::span<double> state) const {
    pack(layout_, start_point(model_, traits, initial), state);
}

void Serving::update(std::span<const std::int32_t> points, std::span<const Mat2> F_inc,
                     std::span<double> states, std::span<stress::SurrogateAnswer> answers) const {
    serve(model_, points, F_inc, states, answers);
}

stress::Tangent Serving::tangent(std::span<const double> state, const Eigen::Vector3d& strain) const {
    return difference_tangent(*this, state, strain);
}

}  // namespace sandgraph::surrogate
