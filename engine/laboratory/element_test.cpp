#include "laboratory/element_test.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <numbers>

#include "base/error.hpp"
#include "dem/element_test/element_test.hpp"
#include "dem/rve_options.hpp"
#include "dem/time_step.hpp"
#include "laboratory/rve_path.hpp"

namespace sandgraph::laboratory {
namespace {

// An optimised kernel relaxes the packing, then an RVE with it follows the path as in a run.
std::vector<dem::ElementRow> run_fast_path(const scene::ElementTestSpec& spec, const dem::Packing& packing) {
    RvePath path{spec.path, spec.material, dem::rve_options(spec.rve, spec.material, packing.r)};
    if (spec.mode == dem::Kernel::mixed) path.options.kernel = dem::RveKernel::mixed;
    const auto assembly = dem::make_assembly(spec.mode, packing, spec.material);
    assembly->step(Mat2::Zero(), path.options.time_step, std::max(1, spec.path.relax_steps));
    return run_rve_path(assembly->packing(), assembly->stress(), path);
}

std::vector<dem::ElementRow> run_path(const scene::ElementTestSpec& spec, const dem::Packing& packing) {
    if (spec.mode != dem::Kernel::reference) return run_fast_path(spec, packing);
    return dem::run_path(*dem::make_assembly(spec.mode, packing, spec.material), spec.path);
}

std::string summary(const dem::ElementRow& last) {
    return fmt::format("{} steps; at the end p = {:.4g} kPa, n = {:.4f}, Z = {:.3f}", last.step,
                       0.5e-3 * last.seen.stress.trace(), last.seen.porosity, last.seen.coordination);
}

std::string summary(const std::vector<dem::BiaxialRow>& rows) {
    const dem::PeakFriction peak = dem::peak_friction(rows);
    return fmt::format("{}; peak within 10 %: {:.2f} deg at eps_a = {:.2f} %", summary(rows.back()),
                       peak.friction_angle * 180 / std::numbers::pi, 100 * peak.axial_strain);
}

std::string summary(const std::vector<dem::ShearRow>& rows) {
    double ratio = 0, count = 0;
    for (const dem::ShearRow& row : rows)
        if (2 * row.shear_strain > rows.back().shear_strain) ratio += row.stress_ratio, ++count;
    return fmt::format("{}; q/p over the late half {:.3f}", summary(rows.back()), ratio / count);
}

std::string summary(const std::vector<dem::ElementRow>& rows) { return summary(rows.back()); }

template <class Row>
ElementOutcome outcome(const std::vector<Row>& rows, const std::string& metadata) {
    return {dem::element_csv(rows, metadata), summary(rows)};
}

// The step of the DEM itself; in a fast path it only divides the path.
void check_time_step(const scene::ElementTestSpec& spec, const dem::Packing& packing) {
    if (spec.kind == scene::TestKind::path && spec.mode != dem::Kernel::reference) return;
    const double limit = 1.25 * dem::critical_time_step(spec.material, packing.r);
    const double time_step = scene::visit_test(spec, [](const auto& test) { return test.time_step; });
    if (time_step <= limit) return;
    throw InputError({"element test", 0}, fmt::format("time_step = {:g} s", time_step),
                     fmt::format("contacts of this packing vibrate apart above {:.2g} s", limit),
                     fmt::format("write a shorter one, {:.2g} s, or leave the key out",
                                 dem::grain_scale(packing, spec.material).time_step));
}

}  // namespace

ElementOutcome run_element_test(const scene::ElementTestSpec& spec, const dem::Packing& packing,
                                const std::string& metadata) {
    check_time_step(spec, packing);
    if (spec.kind == scene::TestKind::path) return outcome(run_path(spec, packing), metadata);
    const dem::GrainScale grains = dem::grain_scale(packing, spec.material);
    const auto sample = dem::make_assembly(spec.mode, packing, spec.material);
    if (spec.kind == scene::TestKind::biaxial)
        return outcome(dem::run_biaxial(*sample, spec.biaxial, grains), metadata);
    if (spec.kind == scene::TestKind::simple_shear)
        return outcome(dem::run_shear(*sample, spec.shear, grains), metadata);
    return outcome(dem::run_isotropic(*sample, spec.isotropic, grains), metadata);
}

}  // namespace sandgraph::laboratory
