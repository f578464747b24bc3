#pragma once
#include <array>
#include <cmath>
#include <complex>

#include "stress/increment.hpp"
#include "stress/surrogate.hpp"

namespace sandgraph::support {

// A closed-form stand-in for a learned law: eight frictional elements side by side with constant
// coefficients (Iwan 1967), K and G growing with the square root of p. Deviators are complex numbers.
class ElementSurrogate : public stress::Surrogate {
  public:
    std::size_t state_size() const override { return kSize; }

    void start(const stress::PackingTraits& traits, const Stress& initial,
               std::span<double> s) const override {
        s[0] = traits.pressure, s[1] = traits.bulk, s[2] = traits.shear;
        s[3] = mean_stress(initial);
        const Complex d{-0.5 * (initial.xx - initial.yy), -initial.xy};
        for (std::size_t k = 0; k < kElements; ++k) put(s, k, d / double(kElements));
    }

    void update(std::span<const std::int32_t> points, std::span<const Mat2> F_inc, std::span<double> states,
                std::span<stress::SurrogateAnswer> answers) const override {
        for (std::size_t k = 0; k < points.size(); ++k) {
            const auto p = static_cast<std::size_t>(points[k]);
            const auto state = states.subspan(p * kSize, kSize);
            drive(state, F_inc[p]);
            answers[k] = {stress_of(state), 0, 0};
        }
    }

    stress::Tangent tangent(std::span<const double> state, const Eigen::Vector3d& strain) const override {
        constexpr double h = 1e-7;
        stress::Tangent out;
        const Eigen::Vector3d bias = strain * (h / std::max(strain.norm(), 1e-300));
        for (int column = 0; column < 3; ++column)
            for (const double sign : {1.0, -1.0}) {
                Eigen::Vector3d e = bias;
                e[column] += 0.5 * sign * h;
                std::array<double, kSize> probe;
                std::copy(state.begin(), state.end(), probe.begin());
                drive(probe, (Mat2() << 1 + e[0], 0.5 * e[2], 0.5 * e[2], 1 + e[1]).finished());
                const Stress s = stress_of(probe);
                const Eigen::Vector3d part(sign * s.xx / h, sign * s.yy / h, sign * s.xy / h);
                if (sign > 0)
                    out.col(column) = part;
                else
                    out.col(column) += part;
            }
        return out;
    }

  private:
    using Complex = std::complex<double>;
    static constexpr std::size_t kElements = 8, kSize = 4 + 2 * kElements;
    static constexpr double kStrength = 0.5;  // sum of the elements' limits: q/p at failure
    static constexpr std::array<double, kElements> kShare = {0.56, 0.23, 0.1, 0.06, 0.03, 0.01, 0.006, 0.004};

    static Complex get(std::span<const double> s, std::size_t k) { return {s[4 + 2 * k], s[5 + 2 * k]}; }
    static void put(std::span<double> s, std::size_t k, Complex t) {
        s[4 + 2 * k] = t.real(), s[5 + 2 * k] = t.imag();
    }

    static void drive(std::span<double> s, const Mat2& F) {
        const stress::Increment e = stress::increment(F);
        const Complex de{-0.5 * (e.xx - e.yy), -e.xy}, turn{e.cos * e.cos - e.sin * e.sin, 2 * e.cos * e.sin};
        const double stiffer = std::sqrt(s[3] / s[0]);
        s[3] = std::max(s[3] - s[1] * stiffer * (e.xx + e.yy), 100.0);
        for (std::size_t k = 0; k < kElements; ++k) {
            Complex t = get(s, k) + 2 * s[2] * stiffer * kShare[k] * de;
            const double limit = kStrength / double(kElements) * s[3], size = std::abs(t);
            if (size > limit) t *= limit / size;
            put(s, k, t * turn);
        }
    }

    static Stress stress_of(std::span<const double> s) {
        Complex sum = 0;
        for (std::size_t k = 0; k < kElements; ++k) sum += get(s, k);
        return {-s[3] - sum.real(), -s[3] + sum.real(), -sum.imag()};
    }
};

}  // namespace sandgraph::support
