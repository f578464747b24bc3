#pragma once
#include <vector>

#include "base/random.hpp"
#include "base/tensor.hpp"
#include "io/history.hpp"
#include "scene/probe_spec.hpp"

namespace sandgraph::laboratory {

// How a leg of a strain path leads the volume: along the prescribed direction of strain, held, or by feedback
// so that the mean stress stays near a target, as it does for a point in the ground.
enum class VolumeControl { prescribed, held, pressure };

// A leg of a strain path. |E| is the Frobenius norm of the strain increment.
struct ProbeLeg {
    double length = 0;  // sum of |E| (of its deviator, where the volume is not prescribed)
    VolumeControl volume = VolumeControl::prescribed;
    double direction = 0;  // prescribed: angle to isotropic compression [rad]; pi/2 shear, pi extension
    double axis = 0;       // principal axis of extension at the start of the leg [rad]
    double turn = 0;       // by which that axis turns over the leg [rad]
    double spin = 0;       // rotation of the point over the leg [rad]
    double pressure = 1;   // target at the end of the leg, in pressures at the start of the path
};

struct ProbePath {
    io::HistoryPath kind = io::HistoryPath::proportional;
    std::vector<ProbeLeg> legs;
    double increment = 1e-4;  // mean |E|, or `share` of p/K at the start, whichever is less
    double share = 1;
    int updates = 1000;        // at most
    bool uneven = false;       // increments between half and twice the mean
    double noise = 0;          // random part of an increment, in units of the regular part
    bool reverting = false;    // the noise takes itself back in the next increment
    std::uint64_t stream = 0;  // of its random numbers
};

// A strain path of `kind` drawn at random by (seed of the recipe, `stream`); probe_draw.cpp.
ProbePath draw_path(io::HistoryPath kind, const scene::ProbeSpec& spec, std::uint64_t stream);

// Walks along a path, increment by increment.
class ProbeWalk {
  public:
    // `pressure`, `bulk`: mean stress and small-strain modulus of the packing at the start [Pa].
    ProbeWalk(const ProbePath& path, double pressure, double bulk, std::uint64_t seed);
    bool done() const { return leg_ == path_.legs.size() || updates_ == path_.updates; }
    // The next F_inc (det > 0), lab frame; `pressure` is the mean stress now [Pa].
    Mat2 next(double pressure);

  private:
    Mat2 regular(const ProbeLeg& leg, double size, double pressure);
    double compression(const ProbeLeg& leg, double size, double pressure);
    Mat2 noise();
    void advance(double size);

    ProbePath path_;
    double pressure_, bulk_;
    Random random_;
    std::size_t leg_ = 0;
    int updates_ = 0;
    double along_ = 0;     // of the leg
    double reached_ = 1;   // target at the end of the leg before
    double dilation_ = 0;  // volume compression a shear of one that kept p so far
    Mat2 last_noise_ = Mat2::Zero();
};

}  // namespace sandgraph::laboratory
