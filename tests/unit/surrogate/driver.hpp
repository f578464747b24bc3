#pragma once
#include <functional>
#include <vector>

#include "surrogate/reference.hpp"
#include "tests/support/random_model.hpp"

namespace sandgraph::surrogate {

// One point of a law.
class Driver {
  public:
    explicit Driver(const stress::Surrogate& law, const Stress& initial = support::rest_stress(),
                    const stress::PackingTraits& traits = support::dense_traits())
        : law_(law), state_(law.state_size()) {
        law.start(traits, initial, state_);
    }
    stress::SurrogateAnswer drive(const Mat2& F) {
        const std::int32_t point = 0;
        stress::SurrogateAnswer answer;
        law_.update({&point, 1}, {&F, 1}, state_, {&answer, 1});
        return answer;
    }
    const std::vector<double>& state() const { return state_; }

  private:
    const stress::Surrogate& law_;
    std::vector<double> state_;
};

inline Mat2 gradient(double xx, double yy, double xy, double yx) {
    return (Mat2() << 1 + xx, xy, yx, 1 + yy).finished();
}
inline Mat2 rotation(double angle) {
    return (Mat2() << std::cos(angle), -std::sin(angle), std::sin(angle), std::cos(angle)).finished();
}
inline Mat2 tensor(const Stress& s) { return (Mat2() << s.xx, s.xy, s.xy, s.yy).finished(); }

// |a - b| over the mean stress of b.
inline double difference(const Stress& a, const Stress& b) {
    return (tensor(a) - tensor(b)).norm() / mean_stress(b);
}

// 60 random increments up to 2e-4 with spin, compressive on the whole.
inline std::vector<Mat2> random_path(std::uint64_t seed, int count = 60, double size = 2e-4) {
    Random random(seed);
    const auto draw = [&] { return random.uniform(-size, size); };
    std::vector<Mat2> path;
    for (int i = 0; i < count; ++i) {
        const double volume = random.uniform(-0.1 * size, 0);
        const double shear = draw(), xy = draw(), yx = draw();
        path.push_back(gradient(volume + shear, volume - shear, xy, yx));
    }
    return path;
}

}  // namespace sandgraph::surrogate
