#include "dem/reference/reference.hpp"

#include <cmath>

#include "base/contracts.hpp"

namespace sandgraph::dem {
namespace {

// a (1 - alpha sign(a (w + dt a / 2))); where the product is zero, so is a.
double damped(double acceleration, double velocity, double dt, double alpha) {
    const double power = acceleration * (velocity + 0.5 * dt * acceleration);
    return acceleration * (1 - std::copysign(alpha, power));
}

}  // namespace

ReferenceAssembly::ReferenceAssembly(const Packing& p, const Material& material)
    : material_(material),
      tan_phi_(std::tan(material.friction_angle)),
      r_max_(0),
      H_(p.H),
      L_(p.L),
      r_(p.r),
      spin_(p.spin),
      torque_(p.size()),
      force_(p.size()) {
    SG_EXPECT(p.size() > 0 && p.y.size() == p.size() && p.r.size() == p.size());
    SG_EXPECT(p.vx.empty() || (p.vx.size() == p.size() && p.vy.size() == p.size()));
    spin_.resize(p.size(), 0.0);
    double r_sum = 0;
    for (std::size_t g = 0; g < p.size(); ++g) {
        x_.emplace_back(p.x[g], p.y[g]);
        v_.push_back(p.vx.empty() ? Vec2(Vec2::Zero()) : Vec2(p.vx[g], p.vy[g]));
        mass_.push_back(material.density * material.depth * std::numbers::pi * r_[g] * r_[g]);
        r_max_ = std::max(r_max_, r_[g]);
        r_sum += r_[g];
    }
    skin_ = 0.1 * r_sum / static_cast<double>(p.size());
    rebuild_pairs();
    restore_history(p.contacts);
}

void ReferenceAssembly::step(const Mat2& L, double dt, int count) {
    SG_EXPECT(dt > 0 && count >= 0);
    if (last_dt_ == 0) last_dt_ = dt;
    for (int k = 0; k < count; ++k) one_step(L, dt);
}

void ReferenceAssembly::one_step(const Mat2& L, double dt) {
    move_cell();
    refresh_pairs();
    apply_forces(dt);
    move_grains(L, dt);
    L_ = L;
    last_dt_ = dt;
    evaluated_ = true;
}

void ReferenceAssembly::move_cell() {
    LH_ = L_ * H_;
    H_ += last_dt_ * LH_;
    listed_F_ += last_dt_ * (L_ * listed_F_);
}

void ReferenceAssembly::apply_forces(double dt) {
    std::fill(force_.begin(), force_.end(), Vec2::Zero());
    std::fill(torque_.begin(), torque_.end(), 0.0);
    for (Pair& pair : pairs_) advance_pair(pair, dt);
}

void ReferenceAssembly::advance_pair(Pair& pair, double dt) {
    const auto [i, j, cx, cy] = pair.key;
    Touch t = pair.touch;
    const bool wrapped = cx != 0 || cy != 0;
    const Vec2 c(cx, cy), d = (wrapped ? Vec2(x_[j] + H_ * c) : x_[j]) - x_[i];
    const double radii = pair.constants.r_i + pair.constants.r_j;
    if (!t.touching && d.squaredNorm() > radii * radii) return;
    if (pair.restored) {
        const Vec2 n = d.normalized();
        t.n = n;
        t.f_t = t.f_t.x() * Vec2(n.y(), -n.x());
        pair.restored = false;
    }
    const Vec2 dv = v_[j] - v_[i];
    const PairMotion motion{d, wrapped ? Vec2(dv + LH_ * c) : dv, spin_[i], spin_[j],
                            dt * (spin_[j] - spin_[i])};
    const bool touch = advance(t, pair.constants, motion, tan_phi_, material_.rolling_form, dt);
    pair.touch = t;
    if (!touch) return;
    const Vec2 f = t.f_n * t.n + t.f_t;
    force_[j] += f;
    force_[i] -= f;
    torque_[i] += torque(t, pair.constants.r_i) - t.moment;
    torque_[j] += torque(t, pair.constants.r_j) + t.moment;
}

// Steps 7 and 8: damped acceleration, convective term, mean-field jump.
void ReferenceAssembly::move_grains(const Mat2& L, double dt) {
    const Mat2 jump = L - L_;
    const double spin_jump = 0.5 * (jump(1, 0) - jump(0, 1)), alpha = material_.damping;
    double w_max = 0;
    for (std::size_t g = 0; g < x_.size(); ++g) {
        const Vec2 w = v_[g] - L_ * x_[g];
        Vec2 a = force_[g] / mass_[g];
        for (int k = 0; k < 2; ++k) a[k] = damped(a[k], w[k], dt, alpha);
        a += L_ * v_[g];
        v_[g] += dt * a;
        const double b = torque_[g] / (0.5 * mass_[g] * r_[g] * r_[g]);
        spin_[g] += dt * damped(b, spin_[g], dt, alpha);
        v_[g] += jump * x_[g];
        spin_[g] += spin_jump;
        w_max = std::max(w_max, (v_[g] - L * x_[g]).squaredNorm());
        x_[g] += dt * v_[g];
    }
    fluctuation_bound_ += dt * std::sqrt(w_max);
}

Mat2 ReferenceAssembly::stress() {
    Mat2 sum = Mat2::Zero();
    if (!evaluated_) return observe().stress;
    for (const Pair& pair : pairs_) {
        const Touch& t = pair.touch;
        if (!t.touching) continue;
        const double branch = pair.constants.r_i + pair.constants.r_j - t.overlap;
        sum += (branch * t.n) * (t.f_n * t.n + t.f_t).transpose();
    }
    return sum / (H_.determinant() * material_.depth);
}

Observables ReferenceAssembly::observe() { return dem::observe(packing(), contacts(), material_); }

std::vector<ContactForce> ReferenceAssembly::contacts() const {
    if (!evaluated_) return contact_forces(packing(), material_);
    std::vector<ContactForce> out;
    for (const Pair& pair : pairs_) {
        const Touch& t = pair.touch;
        if (!t.touching) continue;
        out.push_back({pair.key.i, pair.key.j, pair.key.cell_x, pair.key.cell_y, t.n, t.f_t, t.f_n, t.moment,
                       t.overlap});
    }
    return out;
}

Packing ReferenceAssembly::packing() const {
    Packing p;
    p.H = H_;
    p.r = r_;
    p.spin = spin_;
    p.L = L_;
    for (std::size_t g = 0; g < x_.size(); ++g) {
        p.x.push_back(x_[g].x()), p.y.push_back(x_[g].y());
        p.vx.push_back(v_[g].x()), p.vy.push_back(v_[g].y());
    }
    for (const Pair& pair : pairs_) {
        const Touch& t = pair.touch;
        if (!t.touching) continue;
        const double tangential = pair.restored ? t.f_t.x() : t.f_t.dot(Vec2(t.n.y(), -t.n.x()));
        p.contacts.push_back(
            {pair.key.i, pair.key.j, pair.key.cell_x, pair.key.cell_y, tangential, t.rolling});
    }
    return p;
}

void ReferenceAssembly::set_friction(double tangent) {
    SG_EXPECT(tangent >= 0);
    tan_phi_ = tangent;
    material_.friction_angle = std::atan(tangent);
}

}  // namespace sandgraph::dem
