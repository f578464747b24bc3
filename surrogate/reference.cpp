#include "surrogate/reference.hpp"

#include "base/contracts.hpp"
#include "surrogate/point_update.hpp"

namespace sandgraph::surrogate {

Reference::Reference(Model model)
    : model_(std::move(model)), layout_{model_.elements, model_.members.size()} {}

void Reference::start(const stress::PackingTraits& traits, const Stress& initial,
                      std::span<double> state) const {
    pack(layout_, start_point(model_, traits, initial), state);
}

void Reference::update(std::span<const std::int32_t> points, std::span<const Mat2> F_inc,
                       std::span<double> states, std::span<stress::SurrogateAnswer> answers) const {
    SG_EXPECT(answers.size() == points.size() && distinct_below(points, F_inc.size()));
    for (std::size_t k = 0; k < points.size(); ++k) {
        const auto id = static_cast<std::size_t>(points[k]);
        const std::span<double> state = states.subspan(id * layout_.size(), layout_.size());
        PointState point = unpack(layout_, state);
        answers[k] = update_point(model_, F_inc[id], point);
        pack(layout_, point, state);
    }
}

stress::Tangent Reference::tangent(std::span<const double> state, const Eigen::Vector3d& strain) const {
    return difference_tangent(*this, state, strain);
}

}  // namespace sandgraph::surrogate
