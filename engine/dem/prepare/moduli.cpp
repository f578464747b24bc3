#include "base/contracts.hpp"
#include "dem/grain_scale.hpp"
#include "dem/packing/observe.hpp"
#include "dem/prepare/prepare.hpp"
#include "dem/prepare/stages.hpp"

namespace sandgraph::dem {
namespace {

constexpr int load_steps = 200, relax_steps = 4000;
// Probe strain as a share of the elastic strain p/modulus: far below the first sliding contact.
constexpr double probe_share = 2e-3;

Mat2 mode(double xx, double xy, double yy) { return (Mat2() << xx, xy, xy, yy).finished(); }

struct Probe {
    const Packing& packing;
    Material material;
    const AssemblyFactory& factory;
    double dt, strain;

    // Stress after the symmetric strain `strain * direction` (compression positive), relaxed.
    Mat2 stress_after(const Mat2& direction) const {
        const auto assembly = factory(packing, material);
        assembly->step(-strain / (load_steps * dt) * direction, dt, load_steps);
        assembly->step(Mat2::Zero(), dt, relax_steps);
        return assembly->stress();
    }
    // d(stress)/d(strain); what drifts without strain cancels.
    Mat2 stiffness(const Mat2& direction) const {
        return (stress_after(direction) - stress_after(-direction)) / (2 * strain);
    }
};

}  // namespace

Moduli small_strain_moduli(const Packing& packing, const Material& material, const AssemblyFactory& factory) {
    SG_EXPECT(factory);
    const double pressure =
        0.5 * love_weber_stress(packing, contact_forces(packing, material), material).trace();
    SG_EXPECT(pressure > 0);
    const GrainScale grains = grain_scale(packing, material);
    const Probe probe{packing, calm(material), factory, grains.time_step,
                      probe_share * pressure / grains.modulus};
    const Mat2 iso = probe.stiffness(mode(1, 0, 1)), biaxial = probe.stiffness(mode(1, 0, -1)),
               simple = probe.stiffness(mode(0, 1, 0));
    Moduli moduli;
    moduli.bulk = 0.25 * iso.trace();
    const double shear_biaxial = 0.25 * (biaxial(0, 0) - biaxial(1, 1));
    const double shear_simple = 0.25 * (simple(0, 1) + simple(1, 0));
    moduli.shear = 0.5 * (shear_biaxial + shear_simple);
    moduli.p_wave = moduli.bulk + moduli.shear;
    return moduli;
}

}  // namespace sandgraph::dem
