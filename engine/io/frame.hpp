#pragma once
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "io/h5_group.hpp"

namespace sandgraph::io {

// One named field over the material points of a frame. values.size() == components * points (point-major).
struct Field {
    std::string name;  // e.g. "displacement"
    std::string unit;  // e.g. "m"
    int components = 1;
    std::vector<double> values;
    std::string component_names = {};  // "xx yy xy", parted by blanks; empty: not told
    std::string codes =
        {};  // of a coded field what 0, 1, ... stand for: "surrogate replay", parted by blanks
};

// component_names of a vector in the plane. Of two components in memory, it has a third one, 0, in a file:
// what draws arrows of a file (ParaView) takes three components for a vector, and nothing else.
inline constexpr const char* plane_vector = "x y z";

// The ground at one moment: what run.h5 keeps and ParaView shows.
struct Frame {
    double time = 0;  // [s]
    double d_over_B = 0;
    double plate_x = 0, plate_y = 0;  // current centre of the plate [m]
    std::vector<double> x, y;         // positions of the material points [m]
    std::vector<Field> fields;
};

// One row of load.csv; all for the whole plate (a half model is doubled before it gets here).
struct LoadRow {
    double d_over_B = 0, load = 0;               // [-], [N/m]
    double leading = 0, trailing = 0;            // contact force on the leading and trailing face [N/m]
    double time = 0;                             // [s]
    double kinetic_energy = 0, strain_work = 0;  // strain_work: sum V sigma:d_eps since the start [J/m]
    double plate_work = 0;                       // done by the plate since the start [J/m]
    double rve_active = 0;                       // points that own a packing
    double dem_steps = 0;                        // cumulated
    // Of the load (of the weight on the plate, where that is more), since the row before.
    double damping_share = 0, pic_share = 0, inertia_share = 0;
    // Of runs whose law audits its load: without its error, and the 95 % interval of that [N/m].
    double corrected = 0, low = 0, high = 0;
};

std::string frame_name(std::size_t index);  // "0000", "0001", ...

// One frame as a group: attributes time [s], d_over_B, plate_x, plate_y [m]; datasets `position` (N x 2) [m]
// and each field (N or N x components) with its unit and, where they are told, the attributes `components`
// and `values` (codes). A plane_vector is N x 3.
void write_frame(h5::Group group, const Frame& frame);
Frame read_frame(const h5::Group& group);

}  // namespace sandgraph::io
