#include <cmath>

#include "base/contracts.hpp"
#include "dem/element_test/element_test.hpp"
#include "dem/element_test/sample.hpp"
#include "dem/element_test/servo.hpp"

namespace sandgraph::dem {
namespace {

BiaxialRow biaxial_row(SampleOnStand& sample, double rate, const GrainScale& grains) {
    BiaxialRow row;
    static_cast<ElementRow&>(row) = sample.row();
    const Mat2& s = row.seen.stress;
    row.axial_strain = -std::log(row.F(1, 1));
    row.volumetric_strain = -std::log(row.F.determinant());
    row.p = 0.5 * (s(1, 1) + s(0, 0));
    row.q = 0.5 * (s(1, 1) - s(0, 0));
    row.sin_phi = row.p > 0 ? row.q / row.p : 0;
    row.inertial_number = inertial_number(rate, row.p, grains);
    return row;
}

void shorten(SampleOnStand& sample, StressServo& width, const BiaxialTest& test) {
    const double missing = test.confining_pressure - sample.assembly().stress()(0, 0);
    Mat2 L = Mat2::Zero();
    L(0, 0) = -width.rate(missing, quick_servo_interval * test.time_step);
    L(1, 1) = -test.axial_rate;
    sample.step(L, quick_servo_interval);
}

}  // namespace

std::vector<BiaxialRow> run_biaxial(Assembly& assembly, BiaxialTest test, const GrainScale& grains) {
    by_grains(test.confining_pressure, test.axial_rate, test.time_step, grains);
    SG_EXPECT(test.strain_every > 0);
    compress(assembly,
             {.pressure = test.confining_pressure,
              .rate = test.axial_rate,
              .relax_steps = test.relax_steps,
              .time_step = test.time_step},
             grains);
    SampleOnStand sample(assembly, test.time_step);
    StressServo width = quick_servo(grains, test.axial_rate);
    std::vector<BiaxialRow> rows{biaxial_row(sample, test.axial_rate, grains)};
    while (rows.back().axial_strain < test.axial_strain * (1 - 1e-3)) {
        const double next = static_cast<double>(rows.size()) * test.strain_every;
        while (-std::log(sample.F()(1, 1)) < next) shorten(sample, width, test);
        rows.push_back(biaxial_row(sample, test.axial_rate, grains));
    }
    return rows;
}

PeakFriction peak_friction(std::span<const BiaxialRow> rows, double strain) {
    SG_EXPECT(strain > 0);
    PeakFriction peak;
    double largest = 0;
    for (const BiaxialRow& row : rows) {
        if (row.axial_strain > strain * (1 + 1e-9) || row.sin_phi <= largest) continue;
        largest = row.sin_phi;
        peak = {row.axial_strain, row.p, row.q, std::asin(std::min(1.0, row.sin_phi))};
    }
    return peak;
}

double friction_angle(std::span<const PeakFriction> peaks) {
    double pq = 0, pp = 0;
    for (const PeakFriction& s : peaks) pq += s.p * s.q, pp += s.p * s.p;
    return pp > 0 ? std::asin(pq / pp) : 0;
}

}  // namespace sandgraph::dem
