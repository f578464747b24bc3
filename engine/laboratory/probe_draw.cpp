#include "laboratory/probe_path.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace sandgraph::laboratory {
namespace {

using io::HistoryPath;
using std::numbers::pi;

constexpr double kRowsLeast = 20;  // updates of a path, about
constexpr double kAway = 3e-3;     // length of a leg of several that p cannot follow, at most
constexpr double kApartMin = 1e-4, kApartMax = 2e-2;    // extension that pulls a shearing packing apart
constexpr double kCriticalIncrement = 2e-4;             // |strain increment| of critical-state shear
constexpr double kDitherMin = 1e-6, kDitherMax = 2e-5;  // |strain increment| of grid noise

// Random numbers of the plan; those along the path have the other seed.
class Draw {
  public:
    Draw(const scene::ProbeSpec& spec, std::uint64_t stream)
        : paths_(spec.paths), random_(~spec.seed, stream) {}

    ProbeLeg straight(VolumeControl volume) {
        ProbeLeg leg;
        leg.length = log_uniform(paths_.length_min, paths_.length_max);
        leg.volume = volume;
        leg.axis = uniform(0, pi);
        leg.direction = pi / 2;
        return leg;
    }
    // Half of them near pure shear, the other half anywhere from compression to extension.
    ProbeLeg proportional() {
        ProbeLeg leg = straight(VolumeControl::prescribed);
        leg.direction = chance(0.5) ? uniform(0, pi) : pi / 2 + uniform(-0.2, 0.2);
        return leg;
    }
    ProbeLeg constant_pressure() {
        ProbeLeg leg = straight(VolumeControl::pressure);
        leg.pressure = chance(0.5) ? 1 : std::exp(uniform(-1.2, 1.2));
        return leg;
    }
    // Mostly near constant pressure, as in the ground.
    ProbeLeg any() {
        const double u = uniform(0, 1);
        ProbeLeg leg = u < 0.65   ? constant_pressure()
                       : u < 0.85 ? straight(VolumeControl::held)
                                  : straight(VolumeControl::prescribed);
        if (leg.volume == VolumeControl::prescribed) leg.direction = pi / 2 + uniform(-0.15, 0.15);
        return leg;
    }
    std::vector<ProbeLeg> cyclic() {
        ProbeLeg leg = any();
        const int count = static_cast<int>(uniform(2, 13));
        const double amplitude = log_uniform(paths_.length_min, std::min(0.02, paths_.length_max));
        std::vector<ProbeLeg> legs;
        for (int k = 0; k < count; ++k) {
            leg.length = amplitude * uniform(0.5, 1.5);
            legs.push_back(leg);
            leg.axis += pi / 2, leg.direction = pi - leg.direction;
        }
        return legs;
    }
    ProbeLeg rotating() {
        ProbeLeg leg = any();
        leg.turn = uniform(-2 * pi, 2 * pi), leg.spin = uniform(-1.5, 1.5);
        return leg;
    }
    ProbeLeg leg_of_several() {
        ProbeLeg leg = any();
        if (leg.volume != VolumeControl::pressure) leg.length = std::min(leg.length, kAway);
        return leg;
    }
    // Goes on, reverses or takes another direction; p rises or falls.
    std::vector<ProbeLeg> mixed() {
        const int count = static_cast<int>(uniform(2, 7));
        std::vector<ProbeLeg> legs{leg_of_several()};
        while (static_cast<int>(legs.size()) < count) {
            ProbeLeg leg = leg_of_several();
            const double u = uniform(0, 1), before = legs.back().axis;
            if (u < 0.4) leg.axis = before + uniform(-0.3, 0.3);
            if (u >= 0.4 && u < 0.7) leg.axis = before + pi / 2;
            leg.pressure = legs.back().pressure * std::exp(uniform(-0.7, 0.7));
            leg.spin = uniform(-0.3, 0.3) * std::min(1.0, leg.length / 0.05);
            legs.push_back(leg);
        }
        return legs;
    }
    // A slow trend at nearly constant pressure under the noise of the grid.
    ProbePath dither() {
        ProbePath path;
        path.increment = log_uniform(kDitherMin, kDitherMax);
        path.updates = paths_.dither_rows;
        path.noise = log_uniform(3, 30), path.reverting = chance(0.5), path.uneven = true;
        ProbeLeg leg = any();
        leg.length = path.increment * paths_.dither_rows;
        path.legs = {leg};
        return path;
    }
    // Shear far beyond the peak, as in a developed band: simple shear (which spins) or pure, p led slowly to
    // other values; between two legs the packing may lose its stress and find it again.
    std::vector<ProbeLeg> critical_legs() {
        std::vector<ProbeLeg> legs;
        double axis = uniform(0, pi), pressure = 1;
        for (int left = static_cast<int>(uniform(1, 4)); left > 0; --left) {
            ProbeLeg leg;
            leg.volume = VolumeControl::pressure, leg.axis = axis;
            leg.length = log_uniform(0.1 * paths_.flow_length, paths_.flow_length);
            if (chance(0.5)) leg.spin = (chance(0.5) ? 1 : -1) * leg.length / std::numbers::sqrt2;
            leg.pressure = pressure = std::exp(uniform(-1.5, 1.5));
            legs.push_back(leg);
            if (chance(0.4)) legs.push_back(apart(axis, pressure));
            if (chance(0.4)) axis = chance(0.5) ? axis + pi / 2 : uniform(0, pi);
        }
        return legs;
    }
    ProbeLeg apart(double axis, double pressure) {
        ProbeLeg leg;
        leg.length = log_uniform(kApartMin, kApartMax), leg.axis = axis, leg.pressure = pressure;
        leg.direction = uniform(0.6 * pi, pi);
        return leg;
    }
    ProbePath critical_shear() {
        ProbePath out;
        out.legs = critical_legs();
        double length = 0;
        for (const ProbeLeg& leg : out.legs) length += leg.length;
        out.increment = std::max(kCriticalIncrement, length / paths_.flow_rows);
        out.share = std::numeric_limits<double>::infinity();  // p is held, however stiff
        out.updates = paths_.flow_rows;
        out.uneven = true;
        return out;
    }
    ProbePath path(std::vector<ProbeLeg> legs) {
        double length = 0;
        for (const ProbeLeg& leg : legs) length += leg.length;
        const double shrink = std::min(1.0, paths_.length_max / length);
        for (ProbeLeg& leg : legs) leg.length *= shrink;
        ProbePath out;
        length *= shrink;
        out.increment = std::clamp(log_uniform(paths_.increment_min, paths_.increment_max),
                                   length / paths_.rows_max, length / kRowsLeast);
        out.share = chance(0.8) ? log_uniform(0.05, 0.5) : log_uniform(0.5, 5);
        out.updates = paths_.rows_max;
        out.legs = std::move(legs);
        out.uneven = chance(0.5);
        out.noise = chance(0.5) ? 0 : log_uniform(0.03, 1);
        out.reverting = chance(0.5);
        return out;
    }

  private:
    double uniform(double low, double high) { return random_.uniform(low, high); }
    double log_uniform(double low, double high) { return low * std::pow(high / low, random_.uniform()); }
    bool chance(double p) { return random_.uniform() < p; }
    const scene::ProbePaths& paths_;
    Random random_;
};

ProbePath drawn(HistoryPath kind, Draw& draw) {
    switch (kind) {
        case HistoryPath::proportional:
            return draw.path({draw.proportional()});
        case HistoryPath::constant_volume:
            return draw.path({draw.straight(VolumeControl::held)});
        case HistoryPath::cyclic:
            return draw.path(draw.cyclic());
        case HistoryPath::rotating:
            return draw.path({draw.rotating()});
        case HistoryPath::mixed:
            return draw.path(draw.mixed());
        case HistoryPath::dither:
            return draw.dither();
        case HistoryPath::critical_shear:
            return draw.critical_shear();
        default:
            return draw.path({draw.constant_pressure()});
    }
}

}  // namespace

ProbePath draw_path(HistoryPath kind, const scene::ProbeSpec& spec, std::uint64_t stream) {
    Draw draw(spec, stream);
    ProbePath path = drawn(kind, draw);
    path.kind = kind, path.stream = stream;
    return path;
}

}  // namespace sandgraph::laboratory
