#pragma once
#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "mpm/boundary.hpp"
#include "mpm/grid.hpp"
#include "mpm/order.hpp"
#include "mpm/points.hpp"

namespace sandgraph::mpm {

// Reduced integration for ground of several points a cell. Each of the four points in a cell asks its own
// constraint (a dilation that goes with the shear) of two velocities: bands lock, and loads come out 8 to 12
// % too high. Here a point strains as its cell does on the mean, and keeps a share of what it differs by:
//   L_p <- A L_p + keep (L_p - A L_p),  A L_p = sum_c a_pc L_c,  L_c = sum_q a_qc V_q L_q / sum_q a_qc V_q,
// with a_pc the share of the point's domain in cell c, which changes smoothly as points cross. The internal
// force takes the stress through the same operator, which is its own transpose under the weights V, so that
// the power of the stress is kept. The kept share is what resists the hourglass motion of a cell.
class CellMean {
  public:
    explicit CellMean(double keep = 1);  // 1: full integration, nothing is averaged
    bool active() const { return keep_ < 1; }

    // From the places and volumes at the start of a step; the order must be fresh.
    void weigh(const Points& points, const Order& order, const Grid& grid, const Boundaries& boundaries);
    // The stress that the internal force takes [Pa], by point id.
    const std::vector<Stress>& stress(std::span<const Stress> stress, const Order& order);
    // F_inc, F and volume of every point, as grid_to_points left them, with the mean gradient in them.
    void strain(const Order& order, Points& points);

  private:
    using Four = std::array<double, 4>;
    struct Weight {  // of a point: its cells are `at`, the next, and those of the row above
        std::size_t at = 0;
        std::array<double, 4> share{};
        std::array<std::uint8_t, 4> across{};  // the plate's cut parts the point from the cell's centre
    };
    void add_up(const Order& order, bool volumes);
    void add_point(std::size_t p, bool volumes);
    void add_images(bool volumes);
    void add_image(std::size_t image, std::size_t original);
    Four mean(std::size_t p) const;
    template <class F>
    void each_cell(std::size_t p, F f) const;

    double keep_;
    GridShape shape_;
    Boundaries boundaries_;
    std::size_t stride_ = 0, cells_ = 0;
    std::vector<Weight> weight_;
    std::vector<double> volume_;   // by point, at the start of the step [m2]
    std::vector<double> measure_;  // by cell and side [m2]
    std::vector<Four> value_, sum_;
    std::vector<Stress> stress_;
};

}  // namespace sandgraph::mpm
