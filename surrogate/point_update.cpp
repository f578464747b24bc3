#include "surrogate/point_update.hpp"

#include <fmt/format.h>
#include <Eigen/LU>

#include <array>
#include <numeric>
#include <vector>

#include "base/contracts.hpp"
#include "base/error.hpp"
#include "stress/increment.hpp"
#include "surrogate/coefficients.hpp"

namespace sandgraph::surrogate {
namespace {

struct Evaluated {
    Coefficients coefficients;
    double distance = 0;
};

Evaluated evaluate(const Model& model, const Member& member, const PointState& point,
                   const MemberState& state, double volume) {
    Features x = features(point.constants, state.p, volume, state.deviator(), point.fabric, state.gamma);
    Evaluated e;
    e.distance = clamp_to_trained(model.ranges, x);
    const std::vector<double> outputs =
        member.layers.empty() ? std::vector<double>{} : forward(member.layers, x);
    const double void_ratio = (1 + point.constants.void_ratio) * volume - 1;
    const CriticalPull critical = critical_pull(member.critical, void_ratio, state.p, state.gamma);
    e.coefficients =
        coefficients(model, member, point.constants, state.p, state.strength_scale, critical, outputs);
    return e;
}

MemberState start_member(const Model& model, const Member& member, const PointState& point, double p,
                         Deviator s) {
    MemberState state{p, 0, 1, {s}};
    const Coefficients c = evaluate(model, member, point, state, 1).coefficients;
    const double total = std::accumulate(c.strength.begin(), c.strength.end(), 0.0);
    state.strength_scale = std::max(1.0, std::abs(s) / p / total);
    state.elements.clear();
    for (const double r : c.strength) state.elements.push_back(s * (r / total));
    return state;
}

struct Strain {
    Deviator shear;
    double volume = 0, determinant = 1;
    int substeps = 1;
};

Strain strain_of(const stress::Increment& e, const Mat2& F, double substep) {
    Strain strain{{-0.5 * (e.xx - e.yy), -e.xy}, -(e.xx + e.yy), F(0, 0) * F(1, 1) - F(0, 1) * F(1, 0), 1};
    const double largest = std::max(std::abs(strain.shear), std::abs(strain.volume));
    strain.substeps = static_cast<int>(std::clamp(std::ceil(largest / substep), 1.0, 1000.0));
    return strain;
}

// Returns the distance from the trained range at the last midpoint.
double update_member(const Model& model, const Member& member, const PointState& point, const Strain& strain,
                     MemberState& state) {
    const double n = strain.substeps, p_min = pressure_floor * point.constants.pressure;
    const auto volume = [&](double i) { return point.volume * (1 + (strain.determinant - 1) * i / n); };
    double distance = 0;
    for (int i = 0; i < strain.substeps; ++i) {
        const Evaluated begin = evaluate(model, member, point, state, volume(i));
        const MemberState half = return_map(state, begin.coefficients, member.share, strain.shear / (2 * n),
                                            strain.volume / (2 * n), p_min);
        const Evaluated middle = evaluate(model, member, point, half, volume(i + 0.5));
        state =
            return_map(state, middle.coefficients, member.share, strain.shear / n, strain.volume / n, p_min);
        distance = middle.distance;
    }
    return distance;
}

void turn(const stress::Increment& e, PointState& point) {
    const Deviator phase(e.cos * e.cos - e.sin * e.sin, 2 * e.cos * e.sin);
    point.fabric *= phase;
    for (MemberState& m : point.members)
        for (Deviator& t : m.elements) t *= phase;
}

// Mean and spread of the members' stresses: docs/how_it_works.md (eq. 37a).
stress::SurrogateAnswer answer_of(const PointState& point) {
    double p = 0, spread = 0;
    Deviator s;
    const double n = static_cast<double>(point.members.size());
    for (const MemberState& m : point.members) p += m.p / n, s += m.deviator() / n;
    // Frobenius norm of a plane tensor: |sigma|^2 = 2 p^2 + 2 |s|^2.
    for (const MemberState& m : point.members)
        spread += 2 * ((m.p - p) * (m.p - p) + std::norm(m.deviator() - s)) / n;
    return {{-p - s.real(), -p + s.real(), -s.imag()}, std::sqrt(spread) / std::max(p, 1e3), 0};
}

void check_start(const stress::PackingTraits& t, double p) {
    const double positive[] = {t.pressure, t.porosity, t.bulk, t.shear, t.coordination, t.peak_friction, p};
    for (const double value : positive)
        if (!(value > 0) || !std::isfinite(value))
            throw InputError({"surrogate"}, "a point cannot start from this packing",
                             fmt::format("a trait or the mean stress is {}", value),
                             "give a packing in compression with measured moduli and strength");
}

constexpr double increment_size = 1e-5, difference = 1e-7;

// F = I + strain (xx, yy, engineering xy), symmetric: no rotation.
Mat2 gradient_of(const Eigen::Vector3d& e) {
    return (Mat2() << 1 + e[0], 0.5 * e[2], 0.5 * e[2], 1 + e[1]).finished();
}

Eigen::Vector3d column_of(const Stress& s) { return {s.xx, s.yy, s.xy}; }

}  // namespace

PointState start_point(const Model& model, const stress::PackingTraits& t, const Stress& initial) {
    const double p = mean_stress(initial);
    check_start(t, p);
    const Deviator s(-0.5 * (initial.xx - initial.yy), -initial.xy);
    PointState point;
    point.fabric = {t.fabric_xx, t.fabric_xy};
    point.constants = {t.pressure,     t.porosity / (1 - t.porosity), t.bulk, t.shear, t.coordination,
                       t.peak_friction};
    for (const Member& member : model.members)
        point.members.push_back(start_member(model, member, point, p, s));
    return point;
}

stress::SurrogateAnswer update_point(const Model& model, const Mat2& F_inc, PointState& point) {
    SG_EXPECT(point.members.size() == model.members.size());
    SG_EXPECT(F_inc.determinant() > 0);
    const stress::Increment e = stress::increment(F_inc);
    const Strain strain = strain_of(e, F_inc, model.substep);
    double distance = 0;
    for (std::size_t m = 0; m < model.members.size(); ++m)
        distance =
            std::max(distance, update_member(model, model.members[m], point, strain, point.members[m]));
    point.volume *= strain.determinant;
    turn(e, point);
    stress::SurrogateAnswer answer = answer_of(point);
    answer.distance = distance;
    return answer;
}

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
