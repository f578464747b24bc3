#include "laboratory/probe_path.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "dem/stretch.hpp"

namespace sandgraph::laboratory {
namespace {

// Of the pressure feedback: share of the error corrected at once, and share that goes into the rate.
constexpr double kCorrect = 0.3, kLearn = 0.05;
constexpr double kMost = 1.5;  // compression of an increment at most, in units of its shear

Mat2 extension(double axis) {
    const double c = std::cos(2 * axis), s = std::sin(2 * axis);
    return std::numbers::sqrt2 / 2 * (Mat2() << c, s, s, -c).finished();
}

Mat2 isotropic(double compression) { return -0.5 * compression * Mat2::Identity(); }

}  // namespace

ProbeWalk::ProbeWalk(const ProbePath& path, double pressure, double bulk, std::uint64_t seed)
    : path_(path), pressure_(pressure), bulk_(bulk), random_(seed, path.stream) {
    path_.increment = std::min(path.increment, path.share * pressure / bulk);
}

Mat2 ProbeWalk::next(double pressure) {
    const ProbeLeg& leg = path_.legs[leg_];
    double size = path_.increment;
    if (path_.uneven) size *= std::exp2(random_.uniform(-1, 1));
    size = std::min(size, std::max(leg.length - along_, 0.01 * size));
    const double share = 1 / (1 + path_.noise);
    Mat2 E = regular(leg, share * size, pressure);
    double spin = leg.spin * size / leg.length;
    if (path_.noise > 0) {
        E += (1 - share) * size * noise();
        spin += (1 - share) * size * random_.uniform(-1, 1);
    }
    advance(size);
    return dem::rotation(spin) * (Mat2::Identity() + E);
}

// The part that the path asks for.
Mat2 ProbeWalk::regular(const ProbeLeg& leg, double size, double pressure) {
    const Mat2 shear = extension(leg.axis + leg.turn * along_ / leg.length);
    if (leg.volume == VolumeControl::prescribed)
        return isotropic(std::numbers::sqrt2 * size * std::cos(leg.direction)) +
               size * std::sin(leg.direction) * shear;
    if (leg.volume == VolumeControl::held) return size * shear;
    return isotropic(compression(leg, size, pressure)) + size * shear;
}

// A proportional and integral controller of ln p, in strain: bulk modulus as the square root of p.
double ProbeWalk::compression(const ProbeLeg& leg, double size, double pressure) {
    const double share = along_ / leg.length;
    const double target = pressure_ * std::pow(reached_, 1 - share) * std::pow(leg.pressure, share);
    const double now = std::max(pressure, 0.05 * pressure_);
    const double missing = (target - pressure) / (bulk_ * std::sqrt(now / pressure_));
    dilation_ = std::clamp(dilation_ + kLearn * missing / size, -1.0, 1.0);
    const double most = kMost * size * (1 + path_.noise);
    return std::clamp(kCorrect * missing + dilation_ * size, -most, most);
}

Mat2 ProbeWalk::noise() {
    const auto draw = [this] { return random_.uniform(-1, 1); };
    const double xx = draw(), yy = draw(), xy = draw() / std::numbers::sqrt2;
    const Mat2 fresh = (Mat2() << xx, xy, xy, yy).finished();
    const Mat2 out = path_.reverting ? Mat2(std::numbers::sqrt2 / 2 * (fresh - last_noise_)) : fresh;
    last_noise_ = fresh;
    return out;
}

void ProbeWalk::advance(double size) {
    along_ += size, ++updates_;
    const ProbeLeg& leg = path_.legs[leg_];
    if (along_ < leg.length * (1 - 1e-9)) return;
    reached_ = leg.pressure, along_ = 0, ++leg_;
}

}  // namespace sandgraph::laboratory
