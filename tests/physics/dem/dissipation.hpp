#pragma once
#include <Eigen/LU>
#include <cmath>
#include <map>
#include <utility>
#include <vector>

#include "public_packing.hpp"

namespace sandgraph::dem::test {

// What a step leaves behind: centres and velocities that the next forces are taken with, and the contact
// history.
struct Instant {
    Packing packing;
    Mat2 cell;                                       // of the last forces
    std::map<std::pair<int, int>, Contact> history;  // by grains i < j

    explicit Instant(Assembly& sample) : packing(sample.packing()), cell(sample.cell()) {
        for (Contact c : packing.contacts) {
            if (c.i > c.j) std::swap(c.i, c.j), c.moment = -c.moment;
            history[{c.i, c.j}] = c;
        }
    }
    Vec2 x(int g) const { return {packing.x[g], packing.y[g]}; }
    Vec2 v(int g) const { return {packing.vx[g], packing.vy[g]}; }
    double spin(int g) const { return packing.spin[g]; }
    Contact contact(int i, int j) const {
        const auto found = history.find({i, j});
        return found == history.end() ? Contact{} : found->second;
    }
};

// Heat of each step [J]: what the contact law takes off its trial forces, and what damping takes off the
// forces on the grains. Written out anew, so that it can disagree with the kernels.
class Dissipation {
  public:
    explicit Dissipation(const Material& material) : m_(material) {}
    double sliding = 0, rolling = 0, opening = 0, damping = 0;
    double sum() const { return sliding + rolling + opening + damping; }

    // The step from `before` to `after` under a velocity gradient L that was the same the step before.
    void step(const Instant& before, const Instant& after, const Mat2& L) {
        force_.assign(before.packing.size(), Vec2::Zero()), torque_.assign(before.packing.size(), 0);
        for (const auto& [grains, contact] : after.history) touch(contact, before, after.cell, L);
        for (const auto& [grains, contact] : before.history)
            if (!after.history.contains(grains)) opened(contact, before.packing);
        for (std::size_t g = 0; g < force_.size(); ++g) damp(static_cast<int>(g), before, L);
    }

  private:
    struct Stiffness {
        double n, t, r;
    };
    Stiffness stiffness(double ri, double rj) const {
        const double kn = m_.young * 2 * ri * rj / (ri + rj), kt = m_.stiffness_ratio * kn;
        return {kn, kt, m_.rolling_stiffness * kt * ri * rj};
    }

    void touch(const Contact& now, const Instant& before, const Mat2& cell, const Mat2& L) {
        const int i = now.i, j = now.j;
        const double ri = before.packing.r[i], rj = before.packing.r[j];
        const Vec2 apart = before.x(j) - before.x(i);
        const Vec2 image = (-(cell.inverse() * apart)).array().round();
        const Vec2 d = apart + cell * image, n = d.normalized(), e(n.y(), -n.x());
        const Vec2 dv = before.v(j) - before.v(i) + L * before.cell * image;
        const double vt = (ri + rj) / d.norm() * dv.dot(e) + ri * before.spin(i) + rj * before.spin(j);
        const Stiffness k = stiffness(ri, rj);
        const Contact was = before.contact(i, j);
        sliding += now.tangential * (was.tangential - k.t * dt * vt - now.tangential) / k.t;
        rolling +=
            now.moment * (was.moment - k.r * dt * (before.spin(j) - before.spin(i)) - now.moment) / k.r;
        const double overlap = ri + rj - d.norm();
        const Vec2 f = k.n * overlap * n + now.tangential * e;
        force_[j] += f, force_[i] -= f;
        torque_[i] += (ri - 0.5 * overlap) * now.tangential - now.moment;
        torque_[j] += (rj - 0.5 * overlap) * now.tangential + now.moment;
    }

    void opened(const Contact& was, const Packing& p) {
        const Stiffness k = stiffness(p.r[was.i], p.r[was.j]);
        opening += was.tangential * was.tangential / (2 * k.t) + was.moment * was.moment / (2 * k.r);
    }

    // alpha |F| |velocity in mid-kick|, component by component.
    void damp(int g, const Instant& before, const Mat2& L) {
        const double r = before.packing.r[g], mass = m_.density * m_.depth * std::numbers::pi * r * r,
                     inertia = 0.5 * mass * r * r;
        const Vec2 w = before.v(g) - L * before.x(g) + 0.5 * dt / mass * force_[g];
        damping += m_.damping * dt * force_[g].cwiseProduct(w).cwiseAbs().sum();
        damping +=
            m_.damping * dt * std::abs(torque_[g] * (before.spin(g) + 0.5 * dt / inertia * torque_[g]));
    }

    Material m_;
    std::vector<Vec2> force_;
    std::vector<double> torque_;
};

}  // namespace sandgraph::dem::test
