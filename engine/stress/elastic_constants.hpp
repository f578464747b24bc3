#pragma once

namespace sandgraph::stress {

// Isotropic linear elasticity from Young's modulus [Pa] and Poisson's ratio.
struct ElasticConstants {
    double young = 0, poisson = 0;
    double shear() const { return young / (2 * (1 + poisson)); }                           // G
    double lame() const { return young * poisson / ((1 + poisson) * (1 - 2 * poisson)); }  // lambda
    double p_wave() const { return lame() + 2 * shear(); }                                 // M
};

}  // namespace sandgraph::stress
