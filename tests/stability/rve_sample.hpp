#pragma once
#include <cmath>
#include <string>

#include "dem/fast/fast.hpp"
#include "dem/packing/csv.hpp"
#include "dem/rve.hpp"
#include "dem/stretch.hpp"
#include "support/paths.hpp"
#include "tests/support/table1_options.hpp"

namespace sandgraph::stability {

inline Mat2 increment(double xx, double xy, double yx, double yy) {
    return (Mat2() << 1 + xx, xy, yx, 1 + yy).finished();
}

// One packing of 400 grains on its own, from the public ones at 32 kPa, and what its updates cost.
class RveSample {
  public:
    explicit RveSample(const std::string& density = "dense") : rve(resting(density)) {}

    dem::RveReport drive(const Mat2& F) {
        const dem::RveReport report = rve.update(F, {}, options, work_);
        failures += dem::failed(report.status);
        dem_steps += report.dem_steps;
        inertial_max = std::max(inertial_max, report.inertial_number);
        return report;
    }
    double p() const { return 0.5 * rve.stress().trace(); }
    double q() const {
        const Mat2 s = rve.stress();
        return std::hypot(0.5 * (s(0, 0) - s(1, 1)), 0.5 * (s(0, 1) + s(1, 0)));
    }

    dem::Rve rve;
    dem::RveOptions options = support::table1_options();
    long failures = 0, dem_steps = 0;
    double inertial_max = 0;

  private:
    static std::shared_ptr<const dem::CompactPacking> resting(const std::string& density) {
        const std::string file = sandgraph::test::test_data("/yade/packing_") + density + "_p32.csv";
        dem::FastAssembly a(dem::read_packing_csv(file), {});
        a.step(Mat2::Zero(), 1e-5, 4000);
        return dem::compact(a.packing(), {}, a.stress());
    }
    dem::Workspace work_;
};

}  // namespace sandgraph::stability
