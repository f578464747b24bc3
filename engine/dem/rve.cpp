#include "dem/rve.hpp"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>

#include "base/contracts.hpp"
#include "dem/packing/crushed.hpp"
#include "dem/stretch.hpp"

namespace sandgraph::dem {
namespace {

constexpr double kRoundOff = 1e-14;        // a stretch below it is none: a turn costs no DEM step
constexpr double kLargestIncrement = 0.5;  // Hencky strain an update; beyond it something else is wrong

bool usable(const Mat2& F) { return F.allFinite() && F.determinant() > 1e-3 && F.norm() < 10; }

double mean(const Mat2& compression) { return 0.5 * (compression(0, 0) + compression(1, 1)); }

// Largest strain rate [1/s]: bounded by the inertial number and by the strain of one DEM step.
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

int step_count(double magnitude, double rate, double pressure, const RveOptions& o) {
    const auto driven = static_cast<int>(std::ceil(magnitude / (rate * o.time_step)));
    return std::max({1, o.steps_min, driven, settling_steps(magnitude, pressure, o)});
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
bool cell_too_thin(const FastState& s, const GrainSet& grains) {
    const double longest = std::max(s.H.col(0).norm(), s.H.col(1).norm());
    return !(s.H.determinant() / longest > 4 * grains.radius_max);
}

bool crushed(const CompactPacking& p, const Mat2& stretch) {
    const double area = p.H.determinant() * stretch.determinant();
    return !(1 - p.grains->solid_area / area > crushed_porosity);
}

}  // namespace

RveReport Rve::update(const Mat2& F_inc, const Material& material, const RveOptions& options,
                      Workspace& work) {
    SG_EXPECT(options.time_step > 0 && options.strain_per_step_max > 0 && options.inertial_number_max > 0);
    SG_EXPECT(options.pressure_floor > 0 && options.stress_per_step_max > 0);
    SG_EXPECT(material.density > 0 && material.depth > 0);
    if (!usable(F_inc)) return {RveStatus::bad_increment};
    const Polar increment = polar(turned(F_inc, -angle_));
    if (hencky(increment.U).norm() > kLargestIncrement) return {RveStatus::bad_increment};
    RveReport report{RveStatus::floating};
    double frame_turn = increment.angle;
    if (!floating_) {
        report = drive(increment.U, material, options, work);
    } else if (!keep_floating(increment.U)) {
        const Polar collected = polar(increment.U * pending_);
        report = drive(collected.U, material, options, work);
        frame_turn += collected.angle;
    }
    if (report.status == RveStatus::diverged) return report;
    pending_ = report.status == RveStatus::floating ? Mat2(increment.U * pending_) : Mat2(Mat2::Identity());
    floating_ = report.status == RveStatus::floating;
    angle_ += frame_turn;
    volume_ *= increment.U.determinant();
    settle(options);
    if (floating_) report.status = RveStatus::floating;
    SG_ENSURE(volume_ > 0 && std::isfinite(angle_));
    SG_ENSURE(packing().stress.allFinite() && (!floating_ || packing().stress.isZero(0)));
    return report;
}

// While a packing floats its grains stand still and only the cell's deformation is kept, until the volume at
// which it last carried load comes back; shear since then may have raised that volume by dilation.
bool Rve::keep_floating(const Mat2& U) {
    constexpr double kDilation = 0.5, kDilationMost = 0.08;
    const Mat2 strain = hencky(polar(U * pending_).U);
    const double shear = (strain - 0.5 * strain.trace() * Mat2::Identity()).norm();
    return volume_ * U.determinant() > contact_volume_ * (1 + std::min(kDilationMost, kDilation * shear));
}

RveReport Rve::drive(const Mat2& stretch, const Material& material, const RveOptions& options,
                     Workspace& work) {
    if (hencky(stretch).norm() < kRoundOff) return {};
    const CompactPacking& before = packing();
    if (crushed(before, stretch)) return {RveStatus::diverged};
    const double rate = rate_limit(before, material, options), dt = options.time_step;
    RveReport report;
    report.dem_steps = step_count(hencky(stretch).norm(), rate, mean(before.stress), options);
    const Mat2 L = (root(stretch, report.dem_steps) - Mat2::Identity()) / dt;
    report.inertial_number =
        L.norm() * before.grains->mean_diameter *
        std::sqrt(material.density / std::max(mean(before.stress), options.pressure_floor));
    unpack(before, work.state);
    const Mat2 stress = run(work, kernel_constants(material), material, L, dt, report.dem_steps);
    if (!stress.allFinite() || cell_too_thin(work.state, *before.grains)) {
        report.status = RveStatus::diverged;
        return report;
    }
    if (!own_) {
        own_ = std::make_unique<CompactPacking>();
        own_->grains = initial_->grains;
    }
    pack(work.state, *own_);
    own_->stress = stress;
    SG_ENSURE(report.dem_steps >= 1 && own_->grains == initial_->grains);
    return report;
}

// Decides whether the packing carries load; one that has opened up stands still with exactly zero stress.
void Rve::settle(const RveOptions& options) {
    if (floating_ || !own_) return;
    const double p = mean(own_->stress);
    if (p > options.float_pressure) contact_volume_ = volume_;
    if (p > options.float_pressure || volume_ < contact_volume_ * (1 + options.float_opening)) return;
    own_->stress.setZero(), own_->L.setZero(), own_->LH.setZero();
    std::fill(own_->velocity.begin(), own_->velocity.end(), 0.0f);
    floating_ = true;
}

double Rve::strain_per_step(const Material& material, const RveOptions& options) const {
    return rate_limit(packing(), material, options) * options.time_step;
}

Mat2 Rve::stress() const { return turned(packing().stress, angle_); }

double Rve::porosity() const {
    return 1 - packing().grains->solid_area / (packing().H.determinant() * pending_.determinant());
}

}  // namespace sandgraph::dem
