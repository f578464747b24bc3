#include "training/element_step.hpp"

namespace sandgraph::training::fused {

template <class T>
void Forward<T>::features(const Range<T>& range, const Given<T>& g, const State<T>& s) {
    V sum_re = s.re[0], sum_im = s.im[0];
    for (int k = 1; k < M; ++k) sum_re += s.re[k], sum_im += s.im[k];
    ratio_re = sum_re / s.p, ratio_im = sum_im / s.p;
    log_p = s.p.log();
    eta = (ratio_re.square() + ratio_im.square() + T(1e-4)).sqrt();
    x = {(log_p - T(std::log(1e4))) / T(3),
         g.e,
         eta / T(0.4),
         (T(1) + s.gamma * T(1e3)).log() / T(3),
         g.still[0],
         g.still[1],
         g.still[2],
         g.still[3],
         (ratio_re * g.fabric_re + ratio_im * g.fabric_im) / T(0.1)};
    for (int i = 0; i < X; ++i) {
        free[i] = (x[i] >= range.low[i] && x[i] <= range.high[i]).template cast<T>();
        x[i] = x[i].max(range.low[i]).min(range.high[i]);
    }
}

template <class T>
void Forward<T>::network(const Weights<T>& w, bool net) {
    std::array<V, O> o;
    for (int j = 0; j < O; ++j) o[j] = V::Constant(w.b3[j]);
    if (net) {
        for (int j = 0; j < H; ++j) {
            V sum = V::Constant(w.b1[j]);
            for (int i = 0; i < X; ++i) sum += w.W1[i][j] * x[i];
            h1[j] = sum.tanh();
        }
        for (int j = 0; j < H; ++j) {
            V sum = V::Constant(w.b2[j]);
            for (int i = 0; i < H; ++i) sum += w.W2[i][j] * h1[i];
            h2[j] = sum.tanh();
        }
        for (int j = 0; j < O; ++j)
            for (int i = 0; i < H; ++i) o[j] += w.W3[i][j] * h2[i];
    }
    for (int j = 0; j < O; ++j) sigmoid[j] = T(0.5) + T(0.5) * (T(0.5) * o[j]).tanh();
    for (int k = 0; k < M; ++k) {
        own[k] = o[2 * M + k];
        sigmoid[2 * M + k] = (own[k] + drawn * (toward - own[k])).tanh();
    }
}

// docs/how_it_works.md (eq. 37).
template <class T>
void Forward<T>::critical(const Weights<T>& w, const Given<T>& g, const State<T>& s) {
    gamma2 = s.gamma.square();
    away = g.e + (T(0.22) - w.void_ratio + w.slope * T(1e-5) * s.p) / T(0.04);
    drawn = gamma2 / (gamma2 + w.mature * w.mature);
    toward = -w.pull * away;
}

// (eqs. 36 and 37)
template <class T>
void Forward<T>::coefficients(const Weights<T>& w, const Given<T>& g, const V& scale) {
    const T low = T(1 / bound), span = T(bound - 1 / bound);
    stiffening = ((log_p - g.log_p0) * w.exponent).exp();
    bulk = w.bulk * g.K0 * stiffening * (low + span * sigmoid[3 * M]);
    for (int k = 0; k < M; ++k) {
        shear[k] = w.share[k] * g.G0 * stiffening * (low + span * sigmoid[k]);
        strength[k] = w.strength[k] * scale * (low + span * sigmoid[M + k]);
        const V own = w.share[k] * sigmoid[2 * M + k];
        tanh_wins[k] = (own <= T(2) * strength[k]).template cast<T>();
        dilatancy[k] = own.min(T(2) * strength[k]);
    }
}

// (eq. 35)
template <class T>
void Forward<T>::return_map(const Given<T>& g, const State<T>& s) {
    p_trial = (s.p + bulk * g.dv).max(g.p_least);
    for (int k = 0; k < M; ++k) {
        re[k] = s.re[k] + T(2) * shear[k] * g.de_re;
        im[k] = s.im[k] + T(2) * shear[k] * g.de_im;
        size[k] = (re[k].square() + im[k].square() + T(1e-12)).sqrt();
        coupling[k] = bulk * dilatancy[k] / (T(2) * shear[k]);
    }
    p = p_trial;
    for (int iteration = 0; iteration < 2; ++iteration) {
        raised = p_trial, slope = V::Constant(1);
        for (int k = 0; k < M; ++k) {
            slips[k] = (size[k] > strength[k] * p).template cast<T>();
            raised += slips[k] * coupling[k] * size[k];
            slope += slips[k] * coupling[k] * strength[k];
        }
        p = (raised / slope.max(T(0.1))).max(g.p_least);
    }
    for (int k = 0; k < M; ++k) excess[k] = (size[k] - strength[k] * p).max(T(0));
}

template <class T>
void Forward<T>::run(const Weights<T>& w, const Range<T>& range, const Given<T>& g, const State<T>& s,
                     bool net) {
    features(range, g, s);
    critical(w, g, s);
    network(w, net);
    coefficients(w, g, s.scale);
    return_map(g, s);
}

template <class T>
State<T> Forward<T>::next(const Weights<T>& w, const State<T>& s) const {
    State<T> out{p, s.gamma, {}, {}, s.scale};
    for (int k = 0; k < M; ++k) {
        const V kept = T(1) - excess[k] / size[k];
        out.re[k] = re[k] * kept;
        out.im[k] = im[k] * kept;
        out.gamma += w.share[k] * excess[k] / (T(2) * shear[k]);
    }
    return out;
}

template struct Forward<float>;
template struct Forward<double>;

}  // namespace sandgraph::training::fused
