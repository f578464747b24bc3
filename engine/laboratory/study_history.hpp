#pragma once
#include <string>
#include <vector>

#include "base/tensor.hpp"

namespace sandgraph::laboratory {

// What one material point goes through, increment by increment, as the ground would hand it on.
struct StrainHistory {
    std::string name;
    double pressure = 0;           // isotropic stress of the packing at the start [Pa]
    std::vector<Mat2> increments;  // F_inc of each step
    // First increment of the window whose mean stress counts; 0: every increment counts by itself. Past the
    // peak, and where contacts were lost and are made anew, two runs part like weather: only their means can
    // be compared.
    std::size_t window = 0;

    double length() const;  // sum over the increments of |F_inc - 1|, symmetric part
};

// Mean stress of the usual packings, and of those that are to come loose [Pa].
inline constexpr double study_pressure = 30e3, study_pressure_low = 3e3;
// Errors are shares of the mean stress, of this where that is lower [Pa].
inline constexpr double study_floor = 1e3;

StrainHistory quiet_history();                            // noise of the grid about a slow shear
StrainHistory biaxial_history(double strain);             // isochoric
StrainHistory simple_shear_history(double shear);         // isochoric
StrainHistory reversal_history();                         // 0.5 % and back by half, then on
StrainHistory dilating_shear_history(double shear);       // past the peak, volume follows
StrainHistory opening_history();                          // near zero pressure, to the loss of contacts
StrainHistory recontact_history();                        // contacts lost, sheared afloat, closed again
std::vector<StrainHistory> strain_histories(bool quick);  // all of them; quick: shorter

}  // namespace sandgraph::laboratory
