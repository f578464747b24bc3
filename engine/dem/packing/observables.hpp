#pragma once
#include "base/tensor.hpp"

namespace sandgraph::dem {

// What a packing shows at one force evaluation; compression positive, definitions as in the YADE reference
// files.
struct Observables {
    Mat2 stress = Mat2::Zero();  // Love-Weber: (1/(A h)) sum_c d (x) f [Pa], not symmetrised
    Mat2 fabric = Mat2::Zero();  // (1/Nc) sum n (x) n
    double porosity = 0;
    int contacts = 0;                    // Nc
    double coordination = 0;             // Z = 2 Nc / N
    double mechanical_coordination = 0;  // Zm: mean contacts of disks with >= 2 contacts
    double anisotropy = 0;               // F_a = sqrt(F:F/2), F = 4 (fabric - I/2)
    double sliding_fraction = 0;         // share of contacts at the Coulomb limit
    double elastic_normal = 0, elastic_tangential = 0, elastic_rolling = 0;  // f^2/2k [J], whole depth
    double kinetic_translation = 0, kinetic_rotation = 0;  // fluctuation velocity v - L x [J]
    double overlap_max = 0;                                // [m]
    double unbalanced = 0;  // mean |net force| on a grain / mean |contact force|
};

}  // namespace sandgraph::dem
