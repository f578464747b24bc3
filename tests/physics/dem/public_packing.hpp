#pragma once
#include <memory>
#include <string>

#include "dem/fast/fast.hpp"
#include "dem/mixed/assembly.hpp"
#include "dem/packing/csv.hpp"
#include "dem/prepare/stages.hpp"
#include "dem/reference/reference.hpp"
#include "tests/unit/dem/yade_reference.hpp"

namespace sandgraph::dem::test {

inline constexpr double dt = 1e-5;  // [s], that of the YADE files

inline Mat2 matrix(double xx, double xy, double yx, double yy) {
    return (Mat2() << xx, xy, yx, yy).finished();
}
inline Packing public_packing(const std::string& kind, const std::string& pressure = "p32") {
    return read_packing_csv(yade_file("packing_" + kind + "_" + pressure + ".csv"));
}

enum class KernelKind { reference, fast, mixed };
inline std::unique_ptr<Assembly> assembly(KernelKind kind, const Packing& packing, const Material& material) {
    if (kind == KernelKind::fast) return std::make_unique<FastAssembly>(packing, material);
    if (kind == KernelKind::mixed) return std::make_unique<MixedAssembly>(packing, material);
    return std::make_unique<ReferenceAssembly>(packing, material);
}
inline std::string name_of(const testing::TestParamInfo<KernelKind>& info) {
    if (info.param == KernelKind::mixed) return "Mixed";
    return info.param == KernelKind::fast ? "Fast" : "Reference";
}

// The public packing relaxed with its material under strong damping; velocities dropped.
inline Packing resting(const std::string& density, const Material& material, int steps = 20'000) {
    FastAssembly sample(public_packing(density), calm(material));
    sample.step(Mat2::Zero(), dt, steps);
    return at_rest(sample.packing());
}

inline double relative(const Mat2& a, const Mat2& b) { return (a - b).norm() / b.norm(); }

}  // namespace sandgraph::dem::test
