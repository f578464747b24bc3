#pragma once
#include <Eigen/Core>

#include <array>
#include <cmath>

// One step of one member of the element network for several histories side by side, and its adjoint: the same
// equations as ElementLaw, by hand, because automatic differentiation of a thousand small operations a step
// costs forty times as much.
namespace sandgraph::training::fused {

inline constexpr int M = 8, H = 16, X = 9, O = 3 * M + 1, lanes = 16;
inline constexpr double bound = 3;

template <class T>
using Lanes = Eigen::Array<T, lanes, 1>;

// Constants of a member as the step uses them (exponent, shares... after softmax and the like) or their
// adjoint.
template <class V>
struct Weights {  // in memory one row of numbers, in the order of ElementLaw::constants
    V exponent, bulk, mature, pull, void_ratio, slope;  // the last four of critical state
    std::array<V, M> share, strength;
    std::array<std::array<V, H>, X> W1;
    std::array<V, H> b1;
    std::array<std::array<V, H>, H> W2;
    std::array<V, H> b2;
    std::array<std::array<V, O>, H> W3;
    std::array<V, O> b3;
};

template <class T>
struct State {
    using V = Lanes<T>;
    V p, gamma;
    std::array<V, M> re, im;
    V scale = V::Constant(1);  // strength_scale of surrogate/
};

// What a step is given.
template <class T>
struct Given {
    using V = Lanes<T>;
    V dv, de_re, de_im, e;  // strain; feature of the void ratio
    V p_measured, lead;     // after the step the pressure goes this share of the way to that
    V log_p0, K0, G0, p_least, fabric_re, fabric_im;  // of the packing
    std::array<V, 4> still;                           // features 4 to 7
};

template <class T>
struct Range {
    std::array<T, X> low, high;
};

// Everything on the way of a step, kept for its adjoint.
template <class T>
struct Forward {
    using V = Lanes<T>;
    V log_p, ratio_re, ratio_im, eta, stiffening, bulk, p_trial, raised, slope, p;
    std::array<V, X> x, free;  // features; 1 inside their range, else 0
    std::array<V, H> h1, h2;
    std::array<V, O> sigmoid;       // of the outputs; tanh for the dilatancy
    std::array<V, M> own;           // dilatancy before critical state draws it, before tanh
    V gamma2, drawn, toward, away;  // of critical_pull in surrogate/
    std::array<V, M> shear, strength, dilatancy, tanh_wins, re, im, size, coupling, slips, excess;

    void run(const Weights<T>& w, const Range<T>& range, const Given<T>& g, const State<T>& s, bool net);
    State<T> next(const Weights<T>& w, const State<T>& s) const;

  private:
    void features(const Range<T>& range, const Given<T>& g, const State<T>& s);
    void critical(const Weights<T>& w, const Given<T>& g, const State<T>& s);
    void network(const Weights<T>& w, bool net);
    void coefficients(const Weights<T>& w, const Given<T>& g, const V& scale);
    void return_map(const Given<T>& g, const State<T>& s);
};

// Leads the pressure to the measured one; elements keep their ratio to it. Answers that factor.
template <class T>
Lanes<T> lead(const Given<T>& g, State<T>& s) {
    const Lanes<T> p = s.p + g.lead * (g.p_measured.max(g.p_least) - s.p), factor = p / s.p;
    s.p = p;
    for (int k = 0; k < M; ++k) s.re[k] *= factor, s.im[k] *= factor;
    return factor;
}

// Its adjoint; the factor counts as given.
template <class T>
void lead_back(const Given<T>& g, const Lanes<T>& p_before, State<T>& a) {
    const Lanes<T> factor = T(1) + g.lead * (g.p_measured.max(g.p_least) / p_before - T(1));
    a.p *= T(1) - g.lead;
    for (int k = 0; k < M; ++k) a.re[k] *= factor, a.im[k] *= factor;
}

// Turns the adjoint of the state after a step into that before it, and adds to the weights' adjoint.
template <class T>
void step_back(const Weights<T>& w, const Given<T>& g, const State<T>& s, const Forward<T>& f, bool net,
               State<T>& adjoint, Weights<Lanes<T>>& gradient);

}  // namespace sandgraph::training::fused
