#include "laboratory/run_probe.hpp"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>

#include "dem/rve.hpp"
#include "dem/stretch.hpp"
#include "packings/history_row.hpp"

namespace sandgraph::laboratory {
namespace {

constexpr int kLoose = 20;  // updates below kLeast after which a history ends, or a share of its updates
constexpr int kLooseShare = 20;
constexpr double kLeast = 5;  // mean stress that is hardly any, times that of a packing which floats
constexpr int kCut = 10;      // increments of a finer twin for one, and of the original for one of a coarser

// The packing of one history, and what it went through.
class Specimen {
  public:
    Specimen(const graph::RowPacking& row, const scene::ProbeSpec& spec, std::size_t history, int updates)
        : rve_(row.packing),
          material_(spec.grains.material),
          options_(dem::rve_options(spec.rve, material_, row.packing->grains->radius)),
          stop_(spec.paths.pressure_stop),
          history_(static_cast<std::int32_t>(history)),
          loose_most_(std::max(kLoose, updates / kLooseShare)) {}

    double pressure() const { return mean_stress(tension_positive(rve_.stress())); }
    void drive(const Mat2& F_inc) {
        dem::RveUpdate update;
        update.F_inc = F_inc;
        update.report = rve_.update(F_inc, material_, options_, work_);
        update.stress = rve_.stress(), update.volume_ratio = rve_.volume_ratio();
        update.seen = dem::observe(rve_, material_);
        io::HistoryRow row = packings::history_row(update);
        row.history = history_, row.sequence = static_cast<std::int32_t>(rows_.size());
        row.dt = update.report.dem_steps * options_.time_step;
        loose_ = row.p < kLeast * options_.float_pressure ? loose_ + 1 : 0;
        lost_ = row.status > io::HistoryStatus::floating;
        rows_.push_back(row);
    }
    bool ended() const { return lost_ || loose_ >= loose_most_ || pressure() > stop_; }
    std::vector<io::HistoryRow>& rows() { return rows_; }

  private:
    dem::Rve rve_;
    dem::Material material_;
    dem::RveOptions options_;
    dem::Workspace work_;
    double stop_;
    std::int32_t history_;
    int loose_ = 0, loose_most_;
    bool lost_ = false;
    std::vector<io::HistoryRow> rows_;
};

// F^(1/n) of an increment near the identity: logarithm and exponential by their series.
Mat2 fraction(const Mat2& F, int n) {
    const Mat2 A = F - Mat2::Identity(), A2 = A * A, A3 = A2 * A;
    const Mat2 G = (A - A2 / 2 + A3 / 3 - A3 * A / 4 + A3 * A2 / 5) / n, G2 = G * G;
    return Mat2::Identity() + G + G2 / 2 + G2 * G / 6 + G2 * G2 / 24;
}

// The increments of a twin.
std::vector<Mat2> repeated(const std::vector<io::HistoryRow>& original, const io::HistoryInfo& twin) {
    std::vector<Mat2> out;
    if (twin.twin == io::HistoryTwin::finer) {
        const std::size_t rows =
            std::max<std::size_t>(original.size() / kCut, std::min<std::size_t>(original.size(), 50));
        for (std::size_t k = 0; k < rows; ++k) out.insert(out.end(), kCut, fraction(original[k].F_inc, kCut));
        return out;
    }
    const Mat2 Q = dem::rotation(twin.rotation);
    Mat2 joined = Mat2::Identity();
    for (std::size_t k = 0; k < original.size(); ++k) {
        joined = Q * original[k].F_inc * Q.transpose() * joined;
        if (twin.twin == io::HistoryTwin::coarser && k % kCut != kCut - 1) continue;
        out.push_back(joined);
        joined.setIdentity();
    }
    return out;
}

}  // namespace

std::vector<io::HistoryRow> run_probe(const ProbeJob& job, const ProbePlan& plan,
                                      const std::vector<ProbeSample>& samples, const scene::ProbeSpec& spec) {
    const auto sample = [&](std::size_t history) -> const ProbeSample& {
        return samples[static_cast<std::size_t>(plan.histories[history].packing)];
    };
    const ProbeSample& first = sample(job.first);
    Specimen specimen(first.row, spec, job.first, job.path.updates);
    ProbeWalk walk(job.path, first.traits.pressure, first.traits.bulk, spec.seed);
    while (!walk.done() && !specimen.ended()) specimen.drive(walk.next(specimen.pressure()));
    std::vector<io::HistoryRow> rows = specimen.rows();
    for (std::size_t h = job.first + 1; h < job.first + job.count; ++h) {
        Specimen twin(sample(h).row, spec, h, job.path.updates);
        for (const Mat2& F_inc : repeated(specimen.rows(), plan.histories[h]))
            if (!twin.ended()) twin.drive(F_inc);
        rows.insert(rows.end(), twin.rows().begin(), twin.rows().end());
    }
    return rows;
}

}  // namespace sandgraph::laboratory
