#include <cmath>

#include "base/contracts.hpp"
#include "dem/element_test/sample.hpp"
#include "dem/element_test/servo.hpp"

namespace sandgraph::dem {
namespace {

double mean(const Mat2& stress) { return 0.5 * stress.trace(); }

ShearRow shear_row(SampleOnStand& sample, double rate) {
    ShearRow row;
    static_cast<ElementRow&>(row) = sample.row();
    const Mat2& s = row.seen.stress;
    row.shear_strain = row.F(0, 1) / row.F(1, 1);
    row.volumetric_strain = -std::log(row.F.determinant());
    row.p = mean(s);
    row.q = std::hypot(0.5 * (s(0, 0) - s(1, 1)), 0.5 * (s(0, 1) + s(1, 0)));
    row.stress_ratio = row.p > 0 ? row.q / row.p : 0;
    row.inertial_number = inertial_number(rate, row.p);
    return row;
}

void shear(SampleOnStand& sample, StressServo& area, const ShearTest& test) {
    const double missing = test.pressure - mean(sample.assembly().stress());
    const double shrinking = area.rate(missing, quick_servo_interval * test.dt);  // of the area
    sample.step((Mat2() << -0.5 * shrinking, test.rate, 0, -0.5 * shrinking).finished(),
                quick_servo_interval);
}

}  // namespace

std::vector<ShearRow> run_shear(Assembly& assembly, const ShearTest& test) {
    SG_EXPECT(test.rate > 0 && test.sample_strain > 0);
    SG_EXPECT(test.pressure > 0 && test.modulus > 0 && test.dt > 0);
    compress(assembly, {.pressure = test.pressure,
                        .rate = test.rate,
                        .modulus = test.modulus,
                        .relax_steps = test.relax_steps,
                        .dt = test.dt});
    SampleOnStand sample(assembly, test.dt);
    StressServo area = quick_servo(test.modulus, test.rate);
    std::vector<ShearRow> rows{shear_row(sample, test.rate)};
    while (rows.back().shear_strain < test.strain * (1 - 1e-3)) {
        const double next = static_cast<double>(rows.size()) * test.sample_strain;
        while (sample.F()(0, 1) < next * sample.F()(1, 1)) shear(sample, area, test);
        rows.push_back(shear_row(sample, test.rate));
    }
    return rows;
}

}  // namespace sandgraph::dem
