#pragma once
#include <deque>
#include <mutex>

#include "dem/rve.hpp"
#include "stress/surrogate.hpp"
#include "tests/support/public_packing.hpp"
#include "tests/support/table1_options.hpp"

namespace sandgraph::support {

// A "surrogate" that is a packing of grains itself, its deviator times a known factor: what an audit ought to
// find is then known. A state is the number of its packing; not for copies of states.
class PackingSurrogate : public stress::Surrogate {
  public:
    explicit PackingSurrogate(double stronger = 1) : stronger_(stronger) {}
    std::size_t state_size() const override { return 1; }
    void start(const stress::PackingTraits&, const Stress&, std::span<double> state) const override {
        const std::lock_guard lock(made_);
        state[0] = static_cast<double>(rves_.size());
        rves_.emplace_back(public_packing().packing);
    }
    void update(std::span<const std::int32_t> points, std::span<const Mat2> F_inc, std::span<double> states,
                std::span<stress::SurrogateAnswer> answers) const override {
        dem::Workspace work;
        for (std::size_t k = 0; k < points.size(); ++k) {
            const auto p = static_cast<std::size_t>(points[k]);
            dem::Rve& rve = rves_[static_cast<std::size_t>(states[p])];
            rve.update(F_inc[p], dem::Material{}, table1_options(), work);
            answers[k] = {stronger(tension_positive(rve.stress())), 0, 0};
        }
    }
    stress::Tangent tangent(std::span<const double>, const Eigen::Vector3d&) const override {
        return stress::Tangent::Identity();
    }

  private:
    Stress stronger(const Stress& s) const {
        const double mean = 0.5 * (s.xx + s.yy), half = 0.5 * stronger_ * (s.xx - s.yy);
        return {mean + half, mean - half, stronger_ * s.xy};
    }
    double stronger_;
    mutable std::mutex made_;
    mutable std::deque<dem::Rve> rves_;
};

}  // namespace sandgraph::support
