#pragma once
#include <cmath>

#include "io/frame.hpp"

namespace sandgraph::test {

// A ground whose wedge above a plate at depth 3 moves up by `lift` [m], with a smooth shear band at its edge.
inline io::Frame lifted_wedge(double lift, double width = 6, double depth = 5, double cell = 0.1) {
    io::Frame frame;
    frame.d_over_B = lift, frame.plate_y = depth - 3.05 + lift;
    io::Field u{"displacement", "m", 2, {}}, F{"F", "-", 4, {}}, n{"porosity", "-", 1, {}};
    for (double Y = cell / 2; Y < depth; Y += cell)
        for (double X = cell / 2; X < width; X += cell) {
            const double edge = 0.5 + 0.6 * std::max(0.0, Y - (depth - 3)), s = (X - edge) / 0.25;
            const double inside = Y > depth - 3 ? 0.5 * (1 - std::tanh(s)) : 0;
            const double slope = Y > depth - 3 ? -0.5 / 0.25 / std::pow(std::cosh(s), 2) : 0;
            frame.x.push_back(X), frame.y.push_back(Y + lift * inside);
            u.values.insert(u.values.end(), {0, lift * inside});
            F.values.insert(F.values.end(), {1, 0, lift * slope, 1 - 0.6 * lift * slope});
            n.values.push_back(0.158 + 0.04 * std::abs(slope) / 2);
        }
    frame.fields = {u, F, n};
    return frame;
}

}  // namespace sandgraph::test
