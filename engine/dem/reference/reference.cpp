#include "dem/reference/reference.hpp"

#include <Eigen/LU>

#include <algorithm>
#include <cmath>

#include "base/contracts.hpp"

// The published step, then its Verlet list: when it stays valid, how it is rebuilt, how history is carried
// over. Equations: docs/how_it_works.md.
namespace sandgraph::dem {
namespace {

// a (1 - alpha sign(a (w + dt a / 2))) (eq. 21); where the product is zero, so is a.
double damped(double acceleration, double velocity, double dt, double alpha) {
    const double power = acceleration * (velocity + 0.5 * dt * acceleration);
    return acceleration * (1 - std::copysign(alpha, power));
}

// Spectral norm of a 2x2 matrix.
double norm2(const Mat2& a) {
    const double half = 0.5 * a.squaredNorm(), det = a.determinant();
    return std::sqrt(half + std::sqrt(std::max(0.0, half * half - det * det)));
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

// (eq. 16)
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

// (eqs. 17 to 20)
void ReferenceAssembly::advance_pair(Pair& pair, double dt) {
    const auto [i, j, cx, cy] = pair.key;
    ContactState t = pair.contact;
    const bool wrapped = cx != 0 || cy != 0;
    const Vec2 c(cx, cy), d = (wrapped ? Vec2(x_[j] + H_ * c) : x_[j]) - x_[i];
    const double radii = pair.constants.r_i + pair.constants.r_j;
    if (!t.in_contact && d.squaredNorm() > radii * radii) return;
    if (pair.restored) {
        const Vec2 n = d.normalized();
        t.n = n;
        t.f_t = t.f_t.x() * Vec2(n.y(), -n.x());
        pair.restored = false;
    }
    const Vec2 dv = v_[j] - v_[i];
    const PairMotion motion{d, wrapped ? Vec2(dv + LH_ * c) : dv, spin_[i], spin_[j],
                            dt * (spin_[j] - spin_[i])};
    const bool in_contact = advance(t, pair.constants, motion, tan_phi_, material_.rolling_form, dt);
    pair.contact = t;
    if (!in_contact) return;
    const Vec2 f = t.f_n * t.n + t.f_t;
    force_[j] += f;
    force_[i] -= f;
    torque_[i] += torque(t, pair.constants.r_i) - t.moment;
    torque_[j] += torque(t, pair.constants.r_j) + t.moment;
}

// Damped acceleration and convective term (eq. 21), mean-field jump (eq. 22).
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

// (eq. 23)
Mat2 ReferenceAssembly::stress() {
    Mat2 sum = Mat2::Zero();
    if (!evaluated_) return observe().stress;
    for (const Pair& pair : pairs_) {
        const ContactState& t = pair.contact;
        if (!t.in_contact) continue;
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
        const ContactState& t = pair.contact;
        if (!t.in_contact) continue;
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
        const ContactState& t = pair.contact;
        if (!t.in_contact) continue;
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

// A pair in contact now, |d| < r_i + r_j, lay at |d_0| <= |F^-1| (|d| + 2 u) when the list was built (u:
// largest non-affine displacement), so it is listed as long as this stays below r_i + r_j + skin; large
// grains are worst.
bool ReferenceAssembly::list_is_valid(double fluctuation) const {
    const double stretch = std::max(1.0, norm2(listed_F_.inverse()));
    return stretch * (2 * r_max_ + 2 * fluctuation) <= 2 * r_max_ + skin_;
}

// The running bound adds up the largest speeds; the exact displacement is found only when the bound is used
// up.
void ReferenceAssembly::refresh_pairs() {
    if (list_is_valid(fluctuation_bound_)) return;
    fluctuation_bound_ = largest_fluctuation();
    if (!list_is_valid(1.1 * fluctuation_bound_)) rebuild_pairs();
}

double ReferenceAssembly::largest_fluctuation() const {
    double squared = 0;
    for (std::size_t g = 0; g < x_.size(); ++g)
        squared = std::max(squared, (x_[g] - listed_F_ * listed_x_[g]).squaredNorm());
    return std::sqrt(squared);
}

void ReferenceAssembly::rebuild_pairs() {
    std::vector<Pair> old = std::move(pairs_);
    pairs_.clear();
    auto next = old.begin();
    for (const PairKey& key : near_pairs(x_, r_, H_, skin_)) {
        next = std::find_if(next, old.end(), [&](const Pair& p) { return p.key >= key; });
        const bool known = next != old.end() && next->key == key;
        pairs_.push_back(known ? *next
                               : Pair{key, PairConstants(r_[key.i], r_[key.j], material_), {}, false});
    }
    listed_x_ = x_;
    listed_F_.setIdentity();
    fluctuation_bound_ = 0;
}

void ReferenceAssembly::restore_history(const std::vector<Contact>& contacts) {
    for (const Contact& c : contacts) {
        const PairKey key{c.i, c.j, c.cell_x, c.cell_y};
        const auto it = std::ranges::lower_bound(pairs_, key, {}, &Pair::key);
        if (it == pairs_.end() || it->key != key) continue;
        it->contact.in_contact = it->restored = true;
        it->contact.f_t = {c.tangential, 0};
        it->contact.rolling = c.moment;
    }
}

}  // namespace sandgraph::dem
