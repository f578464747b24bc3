#pragma once
#include <cstdint>
#include <functional>
#include <span>
#include <string>
#include <vector>

#include "base/tensor.hpp"

namespace sandgraph::stress {

// Where the points are, for what a law cannot know from stress and strain.
struct Surroundings {
    std::span<const double> x, y, volume;  // by point [m], [m], [m2]; empty: no neighbours, no energy count
    double cell = 1;                       // [m]
    double d_over_B = 0;
};

// THE contract between the ground (mpm) and what it is made of: a batch of (point, strain increment) in,
// stress out. RVEs, closed-form laws and the surrogate all stand behind it.
struct Batch {
    std::span<const std::int32_t> points;  // ids of the material points to update, each at most once
    std::span<const Mat2> F_inc;  // by point id: increment of the deformation gradient since last step
    std::span<Stress> stress;     // by point id: Cauchy stress [Pa], tension positive; in: old, out: new
    double dt = 0;                // [s]
    Surroundings around = {};
};

// The data of a step that phases share.
enum class Data : std::uint8_t {
    points,      // positions, velocities, deformation, volumes
    increments,  // F_inc of the step
    stress,      // of the points
    order,       // bands of points for the transfers
    grid,        // node sums, forces, motion
    bodies,      // where the rigid bodies are
    contact,     // slip and faces of the points in contact, reactions
    visits,      // what was collected since a point's last answer, and whether its law is due
    due,         // who is asked in this step
    answers,     // of the surrogate
    packings,    // grains, and what they answered
    law,         // other state of the law: modes, blends, internal variables
    energy,      // work done on the points
};
inline constexpr std::size_t data_count = 13;
const char* name_of(Data data);

// A datum as it stands at some moment of the step: 0 as the last step left it, k after its k-th writer,
// `settled` after its last one. Every version has one writer.
inline constexpr int settled = 255;
struct Version {
    Data data;
    int of = 0;
    friend bool operator==(const Version&, const Version&) = default;
};

// One stage of a law's update, with the versions that it reads and the ones that it makes.
struct Stage {
    std::string name;
    std::vector<Version> reads, writes;
    std::function<void(const Batch&)> run;
};

}  // namespace sandgraph::stress
