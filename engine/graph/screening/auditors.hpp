#pragma once
#include <span>
#include <vector>

#include "graph/screening/led_packings.hpp"
#include "graph/screening/modes.hpp"
#include "graph/settings.hpp"

namespace sandgraph::graph {

// Points drawn by chance, most of them where the ground takes most power, whose own packings tell what the
// surrogate's stress errors do to the load: as a virtual work, row by row: docs/how_it_works.md (eqs. 41c to
// 41e). Nothing of it changes the ground by a bit. A sample that is drawn anew takes over when all of its
// packings have caught up; till then the old one measures.
class Auditors {
  public:
    Auditors(std::size_t points, const AuditSettings& settings, LedPackings packings);

    bool present() const { return settings_.load_points > 0; }
    void go_on_from_grains(std::int32_t point, const Mat2& F, std::span<const double> state) {
        packings_.go_on_from_grains(point, F, state);
    }
    // A step, after its answers; `asked`: points that the surrogate has answered for. Returns the DEM steps
    // of all packings.
    std::int64_t after_step(const Followed& ground, std::span<const std::int32_t> asked, const Modes& modes,
                            RvePool& pool, std::int64_t& failures);
    // Known without a sample [J/m].
    void add_known(double missing_work) { known_ += missing_work; }
    stress::VirtualWork take();  // since it was last taken

    // Of the sample that measures: how many, and a point's chance to be in it; 0: it is not.
    std::size_t measuring() const;
    double chance(std::int32_t point) const;
    // sigma_grains - sigma of an auditor, when they were last compared [Pa], tension positive.
    const Stress& shortfall(std::int32_t point) const { return packings_.shortfall(point); }

    void save(ByteWriter& out) const;
    void load(ByteReader& in);

  private:
    struct Auditor {
        std::int32_t point = 0;
        double chance = 0;  // in the sample that measures; 0: not in it
        double next = 0;    // in the one that is being made ready, or the same
    };
    void record(const Followed& ground, std::span<const std::int32_t> asked, const Modes& modes);
    void leave_to_grains(const Modes& modes);
    void draw(const Followed& ground, const Modes& modes, RvePool& pool);
    void enlist(const std::vector<double>& chance, RvePool& pool);
    void take_over(const Followed& ground);
    void count(const Auditor& a, const stress::Batch& batch);
    void forget_step(std::span<const std::int32_t> asked);
    void require_sound() const;

    AuditSettings settings_;
    LedPackings packings_;
    std::vector<double> number_;     // permanent, by point
    std::vector<double> power_;      // by point: V p |d(eps)| of late [J/m], what chances go by
    std::vector<Auditor> auditors_;  // in the order of their points
    bool making_ready_ = false;
    double next_draw_ = 0;  // d/B
    // By point, since last taken [J/m]: work over chance and its part of the standard error, of what grains
    // would take beyond the ground (missing) and of what goes by the same motion and is known for all
    // (moved).
    std::vector<double> missing_, missing_spread_, moved_, moved_spread_;
    double moved_by_all_ = 0, known_ = 0;       // since last taken [J/m]
    double missing_late_ = 0, moved_late_ = 0;  // of the sample, of late [J/m]
    std::vector<double> moved_now_;             // by point, of this step
};

}  // namespace sandgraph::graph
