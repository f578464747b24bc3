#include "surrogate/tangent.hpp"

#include <array>
#include <vector>

#include "base/contracts.hpp"

namespace sandgraph::surrogate {
namespace {

constexpr double increment_size = 1e-5, difference = 1e-7;

// F = I + strain (xx, yy, engineering xy), symmetric: no rotation.
Mat2 gradient_of(const Eigen::Vector3d& e) {
    return (Mat2() << 1 + e[0], 0.5 * e[2], 0.5 * e[2], 1 + e[1]).finished();
}

Eigen::Vector3d column_of(const Stress& s) { return {s.xx, s.yy, s.xy}; }

}  // namespace

stress::Tangent difference_tangent(const stress::Surrogate& law, std::span<const double> state,
                                   const Eigen::Vector3d& strain) {
    SG_EXPECT(state.size() == law.state_size() && strain.allFinite());
    constexpr std::array<std::int32_t, 6> points{0, 1, 2, 3, 4, 5};
    std::array<Mat2, 6> F;
    std::array<stress::SurrogateAnswer, 6> answers;
    std::vector<double> states;
    const double size = strain.norm();
    const Eigen::Vector3d base = size > 0 ? Eigen::Vector3d(strain * (increment_size / size)) : strain;
    for (std::size_t k = 0; k < 6; ++k) {
        F[k] = gradient_of(base + (k % 2 ? -difference : difference) * Eigen::Vector3d::Unit(k / 2));
        states.insert(states.end(), state.begin(), state.end());
    }
    law.update(points, F, states, answers);
    stress::Tangent tangent;
    for (std::size_t j = 0; j < 3; ++j)
        tangent.col(j) =
            (column_of(answers[2 * j].stress) - column_of(answers[2 * j + 1].stress)) / (2 * difference);
    return tangent;
}

}  // namespace sandgraph::surrogate
