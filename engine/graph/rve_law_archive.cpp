#include "graph/rve_law.hpp"

namespace sandgraph::graph {
namespace {

void put(std::vector<double>& out, const Mat2& m) { out.insert(out.end(), m.data(), m.data() + 4); }
void put(std::vector<double>& out, const Stress& s) { out.insert(out.end(), {s.xx, s.yy, s.xy}); }

void take(const double*& in, Mat2& m) {
    std::copy(in, in + 4, m.data());
    in += 4;
}
void take(const double*& in, Stress& s) {
    s = {in[0], in[1], in[2]};
    in += 3;
}

}  // namespace

void RveLaw::archive(Archive& a) {
    std::vector<double> reals;
    std::vector<std::int64_t> integers;
    std::vector<double> sums = {counters_.prediction_error_sum, counters_.inertial_number_max};
    std::vector<std::int64_t> counts = {counters_.dem_steps, counters_.updates, counters_.failures};
    if (!a.reading()) {
        for (std::size_t p = 0; p < rves_.size(); ++p) {
            put(reals, collected_[p]);
            put(reals, change_[p]);
            reals.push_back(allowance_[p]);
            rves_[p].save(reals, integers);
        }
    }
    a.field("rve/reals", reals);
    a.field("rve/integers", integers);
    a.field("rve/sums", sums);
    a.field("rve/counts", counts);
    if (!a.reading()) return;
    const double* real = reals.data();
    const std::int64_t* integer = integers.data();
    for (std::size_t p = 0; p < rves_.size(); ++p) {
        take(real, collected_[p]);
        take(real, change_[p]);
        allowance_[p] = *real++;
        rves_[p].load(real, integer);
    }
    counters_ = {counts[0], counts[1], counts[2], sums[0], sums[1]};
}

}  // namespace sandgraph::graph
