#include <cmath>

#include "base/contracts.hpp"
#include "dem/element_test/sample.hpp"
#include "dem/element_test/servo.hpp"

namespace sandgraph::dem {
namespace {

double mean(const Mat2& stress) { return 0.5 * stress.trace(); }

ShearRow shear_row(SampleOnStand& sample, double rate, const GrainScale& grains) {
    ShearRow row;
    static_cast<ElementRow&>(row) = sample.row();
    const Mat2& s = row.seen.stress;
    row.shear_strain = row.F(0, 1) / row.F(1, 1);
    row.volumetric_strain = -std::log(row.F.determinant());
    row.p = mean(s);
    row.q = std::hypot(0.5 * (s(0, 0) - s(1, 1)), 0.5 * (s(0, 1) + s(1, 0)));
    row.stress_ratio = row.p > 0 ? row.q / row.p : 0;
    row.inertial_number = inertial_number(rate, row.p, grains);
    return row;
}

void shear(SampleOnStand& sample, StressServo& area, const ShearTest& test) {
    const double missing = test.mean_stress - mean(sample.assembly().stress());
    const double shrinking = area.rate(missing, quick_servo_interval * test.time_step);  // of the area
    sample.step((Mat2() << -0.5 * shrinking, test.shear_rate, 0, -0.5 * shrinking).finished(),
                quick_servo_interval);
}

}  // namespace

std::vector<ShearRow> run_shear(Assembly& assembly, ShearTest test, const GrainScale& grains) {
    by_grains(test.mean_stress, test.shear_rate, test.time_step, grains);
    SG_EXPECT(test.strain_every > 0);
    compress(assembly,
             {.pressure = test.mean_stress,
              .rate = test.shear_rate,
              .relax_steps = test.relax_steps,
              .time_step = test.time_step},
             grains);
    SampleOnStand sample(assembly, test.time_step);
    StressServo area = quick_servo(grains, test.shear_rate);
    std::vector<ShearRow> rows{shear_row(sample, test.shear_rate, grains)};
    while (rows.back().shear_strain < test.shear_strain * (1 - 1e-3)) {
        const double next = static_cast<double>(rows.size()) * test.strain_every;
        while (sample.F()(0, 1) < next * sample.F()(1, 1)) shear(sample, area, test);
        rows.push_back(shear_row(sample, test.shear_rate, grains));
    }
    return rows;
}

}  // namespace sandgraph::dem
