#include "stress/elastic.hpp"

#include <utility>

#include "base/contracts.hpp"
#include "stress/increment.hpp"

namespace sandgraph::stress {

Elastic::Elastic(const ElasticConstants& constants, std::vector<Stress> initial)
    : constants_(constants), initial_(std::move(initial)) {
    SG_EXPECT(constants.young > 0 && constants.poisson > -1 && constants.poisson < 0.5);
}

void Elastic::initialise(const Batch& batch) {
    SG_EXPECT(distinct_below(batch.points, batch.stress.size()));
    for (const auto id : batch.points) {
        const auto p = static_cast<std::size_t>(id);
        batch.stress[p] = initial_.at(p);
    }
}

// docs/how_it_works.md (eq. 33).
void Elastic::update(const Batch& batch) {
    SG_EXPECT(distinct_below(batch.points, batch.stress.size()));
    SG_EXPECT(batch.F_inc.size() == batch.stress.size());
    const double lambda = constants_.lame(), G2 = 2 * constants_.shear();
    for (const auto id : batch.points) {
        const auto p = static_cast<std::size_t>(id);
        const Increment e = increment(batch.F_inc[p]);
        const Stress& s = batch.stress[p];
        const double volumetric = lambda * (e.xx + e.yy);
        const Stress turned = {s.xx + volumetric + G2 * e.xx, s.yy + volumetric + G2 * e.yy,
                               s.xy + G2 * e.xy};
        batch.stress[p] = rotate(turned, e.cos, e.sin);
    }
}

}  // namespace sandgraph::stress
