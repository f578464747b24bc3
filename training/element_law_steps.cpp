// The rollout step by step: what fused_rollout.cpp is held against, and with the midpoint rule what is
// served.
#include "training/element_law.hpp"

#include <torch/types.h>
#include <torch/utils.h>

#include <cmath>

namespace sandgraph::training {
namespace {

using torch::Tensor;

constexpr double bound = 3;                                     // of every factor the network sets, both ways
constexpr double pressure_floor = 1e-3;                         // share of p0, as in surrogate/
constexpr std::array<std::int64_t, 4> moving = {0, 2, 3, 8};    // features that follow a member's state
constexpr std::array<std::int64_t, 5> given = {1, 4, 5, 6, 7};  // features known before the rollout

Tensor rows(const Tensor& W, c10::ArrayRef<std::int64_t> which) {
    return W.index_select(-2, torch::tensor(which));
}

Tensor entries(const Tensor& v, c10::ArrayRef<std::int64_t> which) {
    return v.index_select(0, torch::tensor(which));
}

}  // namespace

// What does not change along a rollout.
struct ElementLaw::Fixed {
    const Batch& batch;
    Tensor exponent, log_p0;  // [E, 1], [B]
    Tensor bulk;              // [E, B] at p0
    Tensor share, shear;      // [E, 1, M]; [E, B, M] at p0
    Tensor strength;          // [E, 1, M]
    Tensor begin, middle;     // [T, E, B, H] what the given features put into the first layer
    Tensor W1, low, high;     // of the moving features
    Tensor b3;                // dilatancy and the shift of the bounded factors included
    Tensor p_least;           // [B]
    Tensor scale = Tensor();  // [E, B, 1] strength_scale of surrogate/
    Tensor e_begin = Tensor(), e_middle = Tensor();  // [T, B] void ratio
    Tensor critical = Tensor();                      // [E, 4]
};

struct ElementLaw::State {
    Tensor p, gamma;  // [E, B]
    Tensor t;         // [E, B, 2, M]
    Tensor s;         // [E, B, 2]
};

struct ElementLaw::Coefficients {
    Tensor bulk;                        // [E, B]
    Tensor shear, strength, dilatancy;  // [E, B, M]
};

ElementLaw::Fixed ElementLaw::fix(const Batch& batch) const {
    Fixed f{batch,
            torch::sigmoid(exponent).unsqueeze(1),
            torch::log(batch.p0),
            log_bulk.exp().unsqueeze(1) * batch.K0,
            torch::softmax(share, 1).unsqueeze(1),
            {},
            log_strength.exp().unsqueeze(1),
            {},
            {},
            {},
            {},
            {},
            {},
            pressure_floor * batch.p0};
    f.shear = f.share * batch.G0.unsqueeze(1);
    f.b3 = output_bias();
    f.critical = critical_state();
    f.e_begin = (1 + batch.e0) * batch.J - 1;
    f.e_middle = midpoint ? (1 + batch.e0) * batch.J_middle - 1 : f.e_begin;
    if (rung_ != Rung::learned) return f;
    const Tensor still = torch::stack({(f.log_p0 - std::log(1e4)) / 3, (batch.e0 - 0.22) / 0.04,
                                       (batch.Z0 - 3.5) / 0.5, (batch.sin_phi - 0.5) / 0.1},
                                      1);
    const auto first_layer = [&](const Tensor& void_ratio) {
        const Tensor e = (void_ratio - 0.22) / 0.04;
        const Tensor x = torch::cat({e.unsqueeze(2), still.expand({batch.steps(), -1, -1})}, 2);
        const Tensor inside = torch::minimum(torch::maximum(x, entries(low, given)), entries(high, given));
        return torch::matmul(inside.unsqueeze(1), rows(W1, given)) + b1;
    };
    f.begin = first_layer(f.e_begin);
    f.middle = midpoint ? first_layer(f.e_middle) : f.begin;
    f.W1 = rows(W1, moving), f.low = entries(low, moving), f.high = entries(high, moving);
    return f;
}

// Outputs of the network, constants and shifts included [E, B, outputs].
Tensor ElementLaw::network(const Fixed& f, const State& state, const Tensor& layer1) const {
    if (rung_ != Rung::learned) return f.b3.expand({-1, f.batch.size(), -1});
    const Tensor ratio = state.s / state.p.unsqueeze(2);
    const Tensor x =
        torch::stack({(state.p.log() - std::log(1e4)) / 3, torch::sqrt(ratio.square().sum(2) + 1e-4) / 0.4,
                      torch::log(1 + state.gamma / 1e-3) / 3, (ratio * f.batch.fabric).sum(2) / 0.1},
                     2);
    const Tensor inside = torch::minimum(torch::maximum(x, f.low), f.high);
    const Tensor h1 = torch::tanh(torch::baddbmm(layer1, inside, f.W1));
    const Tensor h2 = torch::tanh(torch::baddbmm(b2, h1, W2));
    return torch::baddbmm(f.b3, h2, W3);
}

// Dilatancies before their tanh `own` [E, B, M], drawn to critical state: critical_pull of surrogate/.
Tensor ElementLaw::drawn(const Fixed& f, const State& state, const Tensor& e, const Tensor& own) {
    const auto constant = [&](std::int64_t i) { return f.critical.narrow(1, i, 1); };  // [E, 1]
    const Tensor g2 = state.gamma.square(), share = g2 / (g2 + constant(0).square());
    const Tensor toward = -constant(1) * (e - constant(2) + constant(3) * state.p / 1e5) / 0.04;
    return own + share.unsqueeze(2) * (toward.unsqueeze(2) - own);
}

ElementLaw::Coefficients ElementLaw::coefficients(const Fixed& f, const State& state, const Tensor& layer1,
                                                  const Tensor& e) const {
    constexpr std::int64_t M = elements;
    const Tensor o = network(f, state, layer1);
    const Tensor factor = 1 / bound + (bound - 1 / bound) * torch::sigmoid(o);
    const Tensor stiffening = torch::exp((state.p.log() - f.log_p0) * f.exponent);
    Coefficients c;
    c.bulk = f.bulk * stiffening * factor.select(2, 3 * M);
    c.shear = f.shear * (stiffening.unsqueeze(2) * factor.narrow(2, 0, M));
    if (rung_ == Rung::elastic) return c;
    c.strength = f.strength * factor.narrow(2, M, M);
    if (f.scale.defined()) c.strength = c.strength * f.scale;
    const Tensor own = drawn(f, state, e, o.narrow(2, 2 * M, M));
    c.dilatancy = torch::minimum(f.share * torch::tanh(own), 2 * c.strength);
    return c;
}

ElementLaw::State ElementLaw::start(const Fixed& f) const {
    const Batch& batch = f.batch;
    State state;
    state.p = batch.p0.expand({members(), -1});
    state.gamma = torch::zeros_like(state.p);
    state.s = batch.s0.expand({members(), -1, -1});
    const Tensor part =
        rung_ == Rung::elastic
            ? f.share.expand({-1, batch.size(), -1})
            : coefficients(f, state, rung_ == Rung::learned ? f.begin[0] : Tensor(), f.e_begin[0]).strength;
    state.t = state.s.unsqueeze(3) * (part / part.sum(2, true)).unsqueeze(2);
    return state;
}

// Implicit in the pressure: slip dilates, which raises p and with it the friction (two Newton iterations on a
// piecewise linear equation).
ElementLaw::State ElementLaw::return_map(const Fixed& f, const State& state, const Coefficients& c,
                                         std::int64_t step, double part) const {
    const Batch& batch = f.batch;
    State next;
    const Tensor G2 = 2 * c.shear;
    const Tensor p_trial = torch::maximum(state.p + c.bulk * (part * batch.dv[step]), f.p_least);
    const Tensor t = state.t + G2.unsqueeze(2) * (part * batch.de[step]).unsqueeze(2);
    if (rung_ == Rung::elastic) return {p_trial, state.gamma, t, t.sum(3)};
    const Tensor size = torch::sqrt(t.square().sum(2) + 1e-12);
    const Tensor coupling = c.bulk.unsqueeze(2) * c.dilatancy / G2;
    const Tensor push = coupling * size, hold = coupling * c.strength;
    Tensor p = p_trial;
    for (int iteration = 0; iteration < 2; ++iteration) {
        const Tensor slips = (size.detach() > (c.strength * p.unsqueeze(2)).detach()).to(size.dtype());
        const Tensor slope = 1 + (hold * slips).sum(2);
        p = torch::maximum((p_trial + (push * slips).sum(2)) / slope.clamp_min(0.1), f.p_least);
    }
    const Tensor excess = torch::relu(size - c.strength * p.unsqueeze(2));
    next.p = p;
    next.gamma = state.gamma + (f.share * excess / G2).sum(2);
    next.t = t * (1 - excess / size).unsqueeze(2);
    next.s = next.t.sum(3);
    return next;
}

// As fused::lead.
void ElementLaw::lead(const Batch& batch, std::int64_t step, State& state) {
    const Tensor measured = torch::maximum(batch.p[step], pressure_floor * batch.p0);
    const Tensor p = state.p + batch.lead[step] * (measured - state.p);
    const Tensor factor = (p / state.p).detach();
    state.p = p;
    state.t = state.t * factor.unsqueeze(2).unsqueeze(3);
    state.s = state.s * factor.unsqueeze(2);
}

Prediction ElementLaw::rollout(const Batch& batch) const {
    if (rung_ == Rung::elastic && batch.lead.any().item<bool>()) {  // no friction ties the elements to p
        Batch unled = batch;
        unled.lead = torch::zeros_like(batch.lead);
        return rollout(unled);
    }
    if (fused && !midpoint) return roll_out_fused(*this, batch);
    Fixed f = fix(batch);
    const bool net = rung_ == Rung::learned;
    State state = start(f);
    if (rung_ != Rung::elastic) {
        const Tensor total =
            coefficients(f, state, net ? f.begin[0] : Tensor(), f.e_begin[0]).strength.sum(2, true);
        const Tensor loaded = batch.s0.norm(2, 1) / batch.p0;
        f.scale = (loaded.unsqueeze(1) / total).clamp_min(1);
    }
    std::vector<Tensor> p, s, slip;
    for (std::int64_t step = 0; step < batch.steps(); ++step) {
        Coefficients c = coefficients(f, state, net ? f.begin[step] : Tensor(), f.e_begin[step]);
        if (midpoint) {
            const State half = return_map(f, state, c, step, 0.5);
            c = coefficients(f, half, net ? f.middle[step] : Tensor(), f.e_middle[step]);
        }
        state = return_map(f, state, c, step, 1);
        p.push_back(state.p);
        s.push_back(state.s);
        slip.push_back(state.gamma);
        lead(batch, step, state);
    }
    return {torch::stack(p), torch::stack(s), torch::stack(slip)};
}

}  // namespace sandgraph::training
