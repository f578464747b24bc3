#include "dem/rve.hpp"

#include <Eigen/LU>

#include <algorithm>
#include <cmath>

#include "base/contracts.hpp"
#include "dem/mixed/packing.hpp"
#include "dem/mixed/visit.hpp"
#include "dem/packing/observe.hpp"
#include "dem/packing/packing.hpp"
#include "dem/reference/contact.hpp"
#include "dem/stretch.hpp"

namespace sandgraph::dem {
namespace {

constexpr double kRoundOff = 1e-14;        // a stretch below it is none: a turn costs no DEM step
constexpr double kLargestIncrement = 0.5;  // Hencky strain an update; beyond it something else is wrong

bool usable(const Mat2& F) { return F.allFinite() && F.determinant() > 1e-3 && F.norm() < 10; }

double mean(const Mat2& compression) { return 0.5 * (compression(0, 0) + compression(1, 1)); }

// docs/how_it_works.md (eq. 27a): by which the bounds loosen where the packing has long been strained one
// way.
double looseness(const StrainRun& run, const RveOptions& o) {
    return o.steady_factor > 1 ? std::clamp(run.length() / o.steady_strain, 1.0, o.steady_factor) : 1;
}

// (eq. 27): largest strain rate [1/s], bounded by the inertial number and by the strain of one DEM step.
double rate_limit(const CompactPacking& p, const Material& m, const RveOptions& o) {
    const double pressure = std::max(mean(p.stress), o.pressure_floor);
    const double inertial = o.inertial_number_max * std::sqrt(pressure / m.density) / p.grains->mean_diameter;
    return std::min(inertial, o.strain_per_step_max / o.time_step);
}

// An update sets the packing in motion and stops it again; the shorter it is and the lower the pressure, the
// more of that shows in its stress. Up to `settle_steps` steps, each changes the stress by at most its share
// of p.
int settling_steps(double magnitude, double pressure, const RveOptions& o) {
    const double change = magnitude * o.modulus / std::max(pressure, o.pressure_floor);
    return static_cast<int>(std::ceil(std::min<double>(change / o.stress_per_step_max, o.settle_steps)));
}

// (eq. 27b): what is in motion already needs to settle only as far as it comes to move more than `jump_max`
// times as fast; 0: always.
int settling_steps_in_motion(const Mat2& strain, const CompactPacking& before, double jump_max,
                             const RveOptions& o) {
    constexpr double kSameWay = 0.8;  // cosine
    const int all = settling_steps(strain.norm(), mean(before.stress), o);
    const Mat2 rate = 0.5 * (before.L + before.L.transpose());
    const double along = (rate.array() * strain.array()).sum();
    if (jump_max <= 0 || !(along > kSameWay * rate.norm() * strain.norm())) return all;
    return static_cast<int>(
        std::min<double>(all, std::ceil(strain.norm() / (jump_max * rate.norm() * o.time_step))));
}

// (eq. 27)
int step_count(const Mat2& strain, double rate, const CompactPacking& before, double jump_max,
               const RveOptions& o) {
    const auto driven = static_cast<int>(std::ceil(strain.norm() / (rate * o.time_step)));
    return std::max({1, o.steps_min, driven, settling_steps_in_motion(strain, before, jump_max, o)});
}

// `count` steps under the constant gradient L: move, forces, kick. Leaves forces and cell in step, so the
// stress of the last evaluation belongs to the deformation reached.
Mat2 run(Workspace& w, const KernelConstants& k, const Material& m, const Mat2& L, double dt, int count) {
    SG_EXPECT(count >= 1 && dt > 0);
    FastState& s = w.state;
    double sum[4], speed2 = drift(s, L, dt);
    s.approach += w.neighbours.approach(s, speed2, dt);
    for (int step = 0; step < count; ++step) {
        if (w.neighbours.stale(s)) w.neighbours.rebuild(s);
        const bool last = step + 1 == count;
        contact_forces(s, k, dt, last ? sum : nullptr);
        speed2 = last ? kick(s, k, dt) : kick_drift(s, k, L, dt);
        if (!last) s.approach += w.neighbours.approach(s, speed2, dt);
    }
    const double volume = s.H.determinant() * m.depth;
    return (Mat2() << sum[0], sum[1], sum[2], sum[3]).finished() / volume;
}

// A period must stay longer than two grains, or a grain would meet its own image.
bool cell_too_thin(const Mat2& H, const GrainSet& grains) {
    const double longest = std::max(H.col(0).norm(), H.col(1).norm());
    return !(H.determinant() / longest > 4 * grains.radius_max);
}
bool cell_too_thin(const Workspace& w, const GrainSet& grains, RveKernel kernel) {
    return kernel == RveKernel::mixed ? too_thin(w.mixed.packing.H, grains.radius_max)
                                      : cell_too_thin(w.state.H, grains);
}

// Takes the packing up, drives it and leaves it in the workspace; its stress.
Mat2 drive_packing(const CompactPacking& before, const Material& m, RveKernel kernel, const Mat2& L,
                   double dt, int count, Workspace& w) {
    const KernelConstants k = kernel_constants(m);
    if (kernel == RveKernel::mixed) {
        unpack(before, w.mixed, w.mixed_list);
        return visit(w.mixed, w.mixed_list, k, m.depth, L, dt, count);
    }
    unpack(before, w.state);
    return run(w, k, m, L, dt, count);
}
void lay_down(const Workspace& w, RveKernel kernel, CompactPacking& out) {
    kernel == RveKernel::mixed ? pack(w.mixed, out) : pack(w.state, out);
}

bool crushed(const CompactPacking& p, const Mat2& stretch) {
    const double area = p.H.determinant() * stretch.determinant();
    return !(1 - p.grains->solid_area / area > crushed_porosity);
}

void put(ByteWriter& out, const Mat2& m) { out.put(std::span<const double>(m.data(), 4)); }
void take(ByteReader& in, Mat2& m) { in.take(std::span<double>(m.data(), 4)); }

void save_packing(const CompactPacking& p, ByteWriter& out) {
    for (const Mat2* m : {&p.H, &p.L, &p.H_force, &p.LH, &p.stress}) put(out, *m);
    out.put(p.approach), out.put(p.pairs), out.put(p.inner);
    out.put(p.position), out.put(p.velocity);
    out.put(p.i), out.put(p.j), out.put(p.image);
    out.put(p.tangential), out.put(p.moment);
    if (p.mixed) save(*p.mixed, out);
}

// One without positions is in the mixed kernel's form, which follows.
void load_packing(CompactPacking& p, ByteReader& in) {
    for (Mat2* m : {&p.H, &p.L, &p.H_force, &p.LH, &p.stress}) take(in, *m);
    in.take(p.approach), in.take(p.pairs), in.take(p.inner);
    in.take(p.position), in.take(p.velocity);
    in.take(p.i), in.take(p.j), in.take(p.image);
    in.take(p.tangential), in.take(p.moment);
    const GrainSet& grains = *p.grains;
    if (p.position.empty()) load(p.mixed.emplace(), int(grains.radius.size()), grains.radius_max, in);
}

// The pair loop indexes by these without a look; the padding grain N is one of its partners.
void require_sound(const CompactPacking& p) {
    const std::size_t grains = p.mixed ? 0 : p.grains->radius.size(), slots = p.i.size();
    require_state(p.position.size() == 2 * grains && p.velocity.size() == 3 * grains, "grains");
    require_state(slots % FastState::kLanes == 0 && p.j.size() == slots && p.image.size() == slots &&
                      p.tangential.size() == slots && p.moment.size() == slots,
                  "pairs");
    const auto most = static_cast<int>(slots);
    require_state(p.pairs >= 0 && p.pairs <= most && p.inner >= 0 && p.inner <= most &&
                      p.inner % FastState::kLanes == 0,
                  "pairs");
    require_indices(p.i, grains + 1, "pairs"), require_indices(p.j, grains + 1, "pairs");
    require_indices(p.image, 9, "pairs");
    for (const Mat2* m : {&p.H, &p.L, &p.H_force, &p.LH, &p.stress}) require_state(m->allFinite(), "numbers");
    require_state(p.H.determinant() > 0, "cells");
    require_state(std::isfinite(p.approach), "numbers");
    const auto finite = [](double value) { return std::isfinite(value); };
    require_state(std::ranges::all_of(p.position, finite) && std::ranges::all_of(p.velocity, finite) &&
                      std::ranges::all_of(p.tangential, finite) && std::ranges::all_of(p.moment, finite),
                  "numbers");
}

void turn(const Mat2& R, std::vector<double>& x, std::vector<double>& y) {
    for (std::size_t k = 0; k < x.size(); ++k) {
        const Vec2 turned = R * Vec2(x[k], y[k]);
        x[k] = turned.x(), y[k] = turned.y();
    }
}

// A pair in contact; d is the branch from i to j.
ContactForce contact_force(const Contact& pair, const Vec2& d, const std::vector<double>& r,
                           const Material& m) {
    const double ri = r[pair.i], rj = r[pair.j];
    ContactForce c{pair.i, pair.j, pair.cell_x, pair.cell_y};
    c.n = d.normalized();
    c.overlap = ri + rj - d.norm();
    c.f_n = PairConstants(ri, rj, m).k_n * c.overlap;
    c.f_t = pair.tangential * Vec2(c.n.y(), -c.n.x());
    const double limit = m.rolling_limit * std::min(ri, rj) * c.f_n;
    c.moment = std::clamp(pair.moment, -limit, limit);
    return c;
}

// Radii as the kernel knows them: their rounding is a share of 1e-4 of an overlap.
std::vector<ContactForce> listed_contacts(const MixedPacking& p, const std::vector<double>& radii,
                                          const Material& m) {
    std::vector<double> r;
    for (const double radius : radii) r.push_back(static_cast<float>(radius));
    std::vector<ContactForce> out;
    out.reserve(p.pairs);
    for_each_pair(p, [&](std::size_t slot, int i, int j) {
        const NearestImage image = nearest_image(p, i, j);
        const Vec2 d = branch(p, image);
        if (d.squaredNorm() >= (r[i] + r[j]) * (r[i] + r[j])) return;
        out.push_back(
            contact_force({i, j, image.cell_x, image.cell_y, p.tangential[slot], p.moment[slot]}, d, r, m));
    });
    return out;
}

// As contact_forces of a Packing, but the pairs are known: a list that the kernel just used holds every
// contact. In the order of the pair loop.
std::vector<ContactForce> listed_contacts(const CompactPacking& p, const Material& m) {
    const std::vector<double>& r = p.grains->radius;
    std::vector<ContactForce> out;
    if (p.mixed) return listed_contacts(*p.mixed, r, m);
    out.reserve(p.i.size());
    for (std::size_t k = 0; k < p.i.size(); ++k) {
        const std::size_t i = p.i[k], j = p.j[k];
        if (i >= r.size() || j >= r.size()) continue;  // a lane that only pads
        const Vec2 cell(p.image[k] / 3 - 1, p.image[k] % 3 - 1);
        const Vec2 d = Vec2(p.position[2 * j], p.position[2 * j + 1]) + p.H * cell -
                       Vec2(p.position[2 * i], p.position[2 * i + 1]);
        const double radii = r[i] + r[j];
        if (d.squaredNorm() >= radii * radii) continue;
        const Contact pair{p.i[k],          p.j[k],     std::int16_t(cell.x()), std::int16_t(cell.y()),
                           p.tangential[k], p.moment[k]};
        out.push_back(contact_force(pair, d, r, m));
    }
    return out;
}

void bring_to_rest(MixedPacking& p) {
    for (auto* velocity : {&p.u, &p.v, &p.w}) std::fill(velocity->begin(), velocity->end(), 0.0f);
    p.L.setZero();
}

// Grains and cell; contact history stays with the pairs.
Packing grains_of(const CompactPacking& p) {
    if (p.mixed) return to_packing(p);
    const std::size_t n = p.grains->radius.size();
    Packing out;
    out.H = p.H, out.L = p.L, out.r = p.grains->radius;
    for (std::vector<double>* v : {&out.x, &out.y, &out.vx, &out.vy, &out.spin}) v->resize(n);
    for (std::size_t g = 0; g < n; ++g) {
        out.x[g] = p.position[2 * g], out.y[g] = p.position[2 * g + 1];
        out.vx[g] = p.velocity[3 * g], out.vy[g] = p.velocity[3 * g + 1], out.spin[g] = p.velocity[3 * g + 2];
    }
    return out;
}

}  // namespace

RveReport Rve::update(const Mat2& F_inc, const Material& material, const RveOptions& options,
                      Workspace& work) {
    SG_EXPECT(options.time_step > 0 && options.strain_per_step_max > 0 && options.inertial_number_max > 0);
    SG_EXPECT(options.pressure_floor > 0 && options.stress_per_step_max > 0);
    SG_EXPECT(material.density > 0 && material.depth > 0);
    if (!usable(F_inc)) return {RveStatus::bad_increment};
    const Polar increment = polar(turned(F_inc, -angle_));  // (eq. 25)
    if (hencky(increment.U).norm() > kLargestIncrement) return {RveStatus::bad_increment};
    RveReport report{RveStatus::floating};
    double frame_turn = increment.angle;
    Mat2 rest = increment.U * pending_;
    if (!floating_ || !keep_floating(increment.U)) {
        const Polar collected = polar(rest);
        report = drive(collected.U, material, options, work, rest);
        frame_turn += collected.angle;
    }
    if (report.status == RveStatus::diverged) return report;
    pending_ = rest;
    floating_ = report.status == RveStatus::floating;
    angle_ += frame_turn;
    volume_ *= increment.U.determinant();
    settle(options);
    if (floating_) report.status = RveStatus::floating, report.unfinished = false;
    SG_ENSURE(volume_ > 0 && std::isfinite(angle_));
    SG_ENSURE(packing().stress.allFinite() && (!floating_ || packing().stress.isZero(0)));
    return report;
}

// While a packing floats its grains stand still and only the cell's deformation is kept, until the volume at
// which it last carried load comes back (eq. 28); shear since then may have raised that volume by dilation.
bool Rve::keep_floating(const Mat2& U) {
    constexpr double kDilation = 0.5, kDilationMost = 0.08;
    const Mat2 strain = hencky(polar(U * pending_).U);
    const double shear = (strain - 0.5 * strain.trace() * Mat2::Identity()).norm();
    return volume_ * U.determinant() > contact_volume_ * (1 + std::min(kDilationMost, kDilation * shear));
}

// `rest`: of the stretch, once it is driven.
RveReport Rve::drive(const Mat2& stretch, const Material& material, const RveOptions& options,
                     Workspace& work, Mat2& rest) {
    const Mat2 strain = hencky(stretch);
    rest.setIdentity();
    if (strain.norm() < kRoundOff) return {};
    const CompactPacking& before = packing();
    if (crushed(before, stretch)) return {RveStatus::diverged};
    const double rate = looseness(run_, options) * rate_limit(before, material, options),
                 dt = options.time_step;
    // The rest of an unfinished update would else settle for ever.
    const bool goes_on = !floating_ && pending_ != Mat2::Identity();
    const double jump_max = goes_on ? std::max(1.0, options.rate_jump_max) : options.rate_jump_max;
    const int all = step_count(strain, rate, before, jump_max, options);
    RveReport report;
    report.dem_steps = options.steps_max > 0 ? std::min(all, options.steps_max) : all;
    report.unfinished = report.dem_steps < all;
    const Mat2 L = (root(stretch, all) - Mat2::Identity()) / dt;  // (eq. 26)
    report.inertial_number =
        L.norm() * before.grains->mean_diameter *
        std::sqrt(material.density / std::max(mean(before.stress), options.pressure_floor));
    const RveKernel kernel = fits_mixed(before) ? options.kernel : RveKernel::double_precision;
    const Mat2 stress = drive_packing(before, material, kernel, L, dt, report.dem_steps, work);
    if (!stress.allFinite() || cell_too_thin(work, *before.grains, kernel)) {
        report.status = RveStatus::diverged;
        return report;
    }
    if (!own_) {
        own_ = std::make_unique<CompactPacking>();
        own_->grains = initial_->grains;
    }
    lay_down(work, kernel, *own_);
    own_->stress = stress;
    const double share = double(report.dem_steps) / all;
    run_.add(share * strain);
    if (report.unfinished) rest = power(stretch, 1 - share);
    SG_ENSURE(report.dem_steps >= 1 && own_->grains == initial_->grains);
    return report;
}

// Decides whether the packing carries load; one that has opened up stands still with exactly zero stress.
void Rve::settle(const RveOptions& options) {
    if (floating_ || !own_) return;
    const double p = mean(own_->stress);
    if (p > options.float_pressure) contact_volume_ = volume_ / pending_.determinant();
    if (p > options.float_pressure || volume_ < contact_volume_ * (1 + options.float_opening)) return;
    own_->stress.setZero(), own_->L.setZero(), own_->LH.setZero();
    std::fill(own_->velocity.begin(), own_->velocity.end(), 0.0f);
    if (own_->mixed) bring_to_rest(*own_->mixed);
    floating_ = true;
}

double Rve::strain_per_step(const Material& material, const RveOptions& options) const {
    return looseness(run_, options) * rate_limit(packing(), material, options) * options.time_step;
}

Mat2 Rve::stress() const { return turned(packing().stress, angle_); }

Mat2 Rve::strain_to_follow() const {
    if (floating_) return Mat2::Zero();
    return turned(hencky(pending_), angle_);
}

double Rve::porosity() const {
    return 1 - packing().grains->solid_area / (packing().H.determinant() * pending_.determinant());
}

void Rve::save(ByteWriter& out) const {
    out.put(own_ != nullptr), out.put(floating_);
    out.put(angle_), out.put(volume_), out.put(contact_volume_);
    put(out, pending_), run_.save(out);
    if (own_) save_packing(*own_, out);
}

void Rve::load(ByteReader& in) {
    bool own = false;
    in.take(own), in.take(floating_);
    in.take(angle_), in.take(volume_), in.take(contact_volume_);
    take(in, pending_), run_.load(in);
    require_state(std::isfinite(angle_) && volume_ > 0 && contact_volume_ > 0 && pending_.allFinite(),
                  "numbers");
    // The rest of one update's strain: more would be driven for hours.
    require_state((pending_ - Mat2::Identity()).cwiseAbs().maxCoeff() < 0.5, "numbers");
    require_state(own || !floating_, "flags");  // only a packing of its own opens up
    own_.reset();
    if (!own) return;
    auto packing = std::make_unique<CompactPacking>();
    packing->grains = initial_->grains;
    load_packing(*packing, in);
    require_sound(*packing);
    own_ = std::move(packing);
}

// Tangential forces and moments are scalars of the contact and turn with it.
Packing lab_packing(const Rve& rve) {
    Packing packing = to_packing(rve.packing());
    const Mat2 R = rotation(rve.angle());
    packing.H = R * packing.H, packing.L = turned(packing.L, rve.angle());
    turn(R, packing.x, packing.y), turn(R, packing.vx, packing.vy);
    return packing;
}

// The packing lies in its own frame, which turned with the point.
Observables observe(const Rve& rve, const Material& material) {
    const CompactPacking& packing = rve.packing();
    Observables seen = observe(grains_of(packing), listed_contacts(packing, material), material);
    seen.stress = rve.stress();
    seen.fabric = turned(seen.fabric, rve.angle());
    seen.porosity = rve.porosity();
    return seen;
}

}  // namespace sandgraph::dem
