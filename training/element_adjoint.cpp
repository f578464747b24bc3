#include "training/element_step.hpp"

namespace sandgraph::training::fused {
namespace {

// Adjoints of a step's intermediate values.
template <class T>
struct Back {
    using V = Lanes<T>;
    V p = V::Zero(), bulk = V::Zero(), stiffening = V::Zero(), log_p = V::Zero();
    V drawn = V::Zero(), toward = V::Zero();
    V re = V::Zero(), im = V::Zero();  // of sum t_k
    std::array<V, M> shear, strength, dilatancy, size;
    std::array<V, O> output;
};

// Through slip, pressure and trial stress; `a` is the adjoint after the step.
template <class T>
void through_return_map(const Weights<T>& w, const Given<T>& g, const Forward<T>& f, State<T>& a, Back<T>& b,
                        Weights<Lanes<T>>& gradient) {
    using V = Lanes<T>;
    V p = a.p;
    for (int k = 0; k < M; ++k) {
        const V kept = T(1) - f.excess[k] / f.size[k], slip = f.excess[k] / (T(2) * f.shear[k]);
        const V of_kept = a.re[k] * f.re[k] + a.im[k] * f.im[k];
        const V open = (f.excess[k] > T(0)).template cast<T>();
        const V of_excess = open * (a.gamma * w.share[k] / (T(2) * f.shear[k]) - of_kept / f.size[k]);
        gradient.share[k] += a.gamma * slip;
        b.shear[k] = -a.gamma * w.share[k] * slip / f.shear[k];
        b.size[k] = of_kept * f.excess[k] / f.size[k].square() + of_excess;
        b.strength[k] = -of_excess * f.p;
        p -= of_excess * f.strength[k];
        a.re[k] *= kept;
        a.im[k] *= kept;
    }
    const V slope = f.slope.max(T(0.1));
    const V raised = (f.p > g.p_least).template cast<T>() * p / slope;
    const V of_slope = -(f.slope > T(0.1)).template cast<T>() * raised * f.raised / slope;
    for (int k = 0; k < M; ++k) {
        const V of_coupling = f.slips[k] * (raised * f.size[k] + of_slope * f.strength[k]);
        b.size[k] += f.slips[k] * raised * f.coupling[k];
        b.strength[k] += f.slips[k] * of_slope * f.coupling[k];
        b.bulk += of_coupling * f.dilatancy[k] / (T(2) * f.shear[k]);
        b.dilatancy[k] = of_coupling * f.bulk / (T(2) * f.shear[k]);
        b.shear[k] -= of_coupling * f.coupling[k] / f.shear[k];
        a.re[k] += b.size[k] * f.re[k] / f.size[k];
        a.im[k] += b.size[k] * f.im[k] / f.size[k];
        b.shear[k] += T(2) * (a.re[k] * g.de_re + a.im[k] * g.de_im);
    }
    b.p = (f.p_trial > g.p_least).template cast<T>() * raised;
    b.bulk += b.p * g.dv;
}

template <class T>
void through_coefficients(const Weights<T>& w, const Given<T>& g, const Lanes<T>& scale, const Forward<T>& f,
                          Back<T>& b, Weights<Lanes<T>>& gradient) {
    using V = Lanes<T>;
    const T low = T(1 / bound), span = T(bound - 1 / bound);
    const auto of_sigmoid = [&](int j) { return span * f.sigmoid[j] * (T(1) - f.sigmoid[j]); };
    for (int k = 0; k < M; ++k) {
        const V shear = low + span * f.sigmoid[k], strength = low + span * f.sigmoid[M + k];
        const V& tanh = f.sigmoid[2 * M + k];
        const V own = f.tanh_wins[k] * b.dilatancy[k];
        b.strength[k] += T(2) * (b.dilatancy[k] - own);
        const V of_tanh = own * w.share[k] * (T(1) - tanh.square());
        b.output[2 * M + k] = of_tanh * (T(1) - f.drawn);
        b.drawn += of_tanh * (f.toward - f.own[k]);
        b.toward += of_tanh * f.drawn;
        gradient.share[k] += own * tanh + b.shear[k] * g.G0 * f.stiffening * shear;
        gradient.strength[k] += b.strength[k] * strength * scale;
        b.output[M + k] = b.strength[k] * w.strength[k] * scale * of_sigmoid(M + k);
        b.stiffening += b.shear[k] * w.share[k] * g.G0 * shear;
        b.output[k] = b.shear[k] * w.share[k] * g.G0 * f.stiffening * of_sigmoid(k);
    }
    const V factor = low + span * f.sigmoid[3 * M];
    gradient.bulk += b.bulk * g.K0 * f.stiffening * factor;
    b.stiffening += b.bulk * w.bulk * g.K0 * factor;
    b.output[3 * M] = b.bulk * w.bulk * g.K0 * f.stiffening * of_sigmoid(3 * M);
    gradient.exponent += b.stiffening * f.stiffening * (f.log_p - g.log_p0);
    b.log_p += b.stiffening * f.stiffening * w.exponent;
}

// Answers the adjoint of gamma.
template <class T>
Lanes<T> through_critical(const Weights<T>& w, const State<T>& s, const Forward<T>& f, Back<T>& b,
                          Weights<Lanes<T>>& gradient) {
    using V = Lanes<T>;
    const T mature2 = w.mature * w.mature;
    const V sum = f.gamma2 + mature2, of_sum = b.drawn / sum.square();
    const V of_away = -w.pull * b.toward / T(0.04);
    gradient.pull -= b.toward * f.away;
    gradient.void_ratio -= of_away;
    gradient.slope += of_away * T(1e-5) * s.p;
    gradient.mature -= of_sum * f.gamma2 * T(2) * w.mature;
    b.p += of_away * w.slope * T(1e-5);
    return of_sum * mature2 * T(2) * s.gamma;
}

// Answers the adjoint of the features.
template <class T>
std::array<Lanes<T>, X> through_network(const Weights<T>& w, const Forward<T>& f, const Back<T>& b,
                                        Weights<Lanes<T>>& gradient) {
    using V = Lanes<T>;
    std::array<V, H> h2, h1;
    std::array<V, X> x;
    for (int i = 0; i < H; ++i) {
        h2[i] = V::Zero();
        for (int j = 0; j < O; ++j) {
            h2[i] += w.W3[i][j] * b.output[j];
            gradient.W3[i][j] += f.h2[i] * b.output[j];
        }
        h2[i] *= T(1) - f.h2[i].square();
        gradient.b2[i] += h2[i];
    }
    for (int i = 0; i < H; ++i) {
        h1[i] = V::Zero();
        for (int j = 0; j < H; ++j) {
            h1[i] += w.W2[i][j] * h2[j];
            gradient.W2[i][j] += f.h1[i] * h2[j];
        }
        h1[i] *= T(1) - f.h1[i].square();
        gradient.b1[i] += h1[i];
    }
    for (int i = 0; i < X; ++i) {
        x[i] = V::Zero();
        for (int j = 0; j < H; ++j) {
            x[i] += w.W1[i][j] * h1[j];
            gradient.W1[i][j] += f.x[i] * h1[j];
        }
        x[i] *= f.free[i];
    }
    return x;
}

template <class T>
void through_features(const Given<T>& g, const State<T>& s, const Forward<T>& f,
                      const std::array<Lanes<T>, X>& x, State<T>& a, Back<T>& b) {
    using V = Lanes<T>;
    b.log_p += x[0] / T(3);
    const V of_eta = x[2] / (T(0.4) * f.eta), along = x[8] / T(0.1);
    const V re = of_eta * f.ratio_re + along * g.fabric_re, im = of_eta * f.ratio_im + along * g.fabric_im;
    b.re = re / s.p, b.im = im / s.p;
    b.p -= b.re * f.ratio_re + b.im * f.ratio_im;
    a.gamma += x[3] * T(1e3 / 3) / (T(1) + s.gamma * T(1e3));
}

}  // namespace

template <class T>
void step_back(const Weights<T>& w, const Given<T>& g, const State<T>& s, const Forward<T>& f, bool net,
               State<T>& a, Weights<Lanes<T>>& gradient) {
    Back<T> b;
    through_return_map(w, g, f, a, b, gradient);
    through_coefficients(w, g, s.scale, f, b, gradient);
    for (int j = 0; j < O; ++j) gradient.b3[j] += b.output[j];
    a.gamma += through_critical(w, s, f, b, gradient);
    if (net) through_features(g, s, f, through_network(w, f, b, gradient), a, b);
    a.p = b.p + b.log_p / s.p;
    for (int k = 0; k < M; ++k) a.re[k] += b.re, a.im[k] += b.im;
}

template void step_back(const Weights<float>&, const Given<float>&, const State<float>&,
                        const Forward<float>&, bool, State<float>&, Weights<Lanes<float>>&);
template void step_back(const Weights<double>&, const Given<double>&, const State<double>&,
                        const Forward<double>&, bool, State<double>&, Weights<Lanes<double>>&);

}  // namespace sandgraph::training::fused
