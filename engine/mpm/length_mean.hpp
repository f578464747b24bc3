#pragma once
#include <array>
#include <vector>

#include "mpm/grid.hpp"
#include "mpm/order.hpp"
#include "mpm/points.hpp"

namespace sandgraph::mpm {

using Deviator = Eigen::Array2d;  // (xx - yy)/2 and xy of a symmetric tensor

// The mean A of a field over a length. Points give it to the nodes by their volumes V, conservative passes
// spread it there with what the nodes' volumes v let through, and points read it back:
//   f_i = sum_p S_ip V_p f_p / v_i,  f_i += sum_j c min(v_i, v_j)(f_j - f_i)/v_i,  (A f)_p = sum_i S_ip f_i.
// A is its own transpose, sum_p V_p f_p (A g)_p = sum_p V_p g_p (A f)_p, and a uniform field is its own mean.
// Nothing passes through the sides, into empty nodes or through a thin body.
class LengthMean {
  public:
    LengthMean() = default;
    // variance of A along an axis [m2], with the part of cells and domains; half side of domains, cell [m].
    LengthMean(double variance, double half, double cell);
    int passes() const { return passes_; }

    // From the places and volumes at the start of a step; the order must be fresh.
    void weigh(const Points& points, const Order& order, const Grid& grid);
    // out = A field, by point id.
    void mean(const std::vector<Deviator>& field, const Order& order, std::vector<Deviator>& out);

  private:
    struct Weight {  // of a point on its 3 x 3 nodes
        std::size_t first = 0;
        std::array<double, 3> x{}, y{};
        unsigned across = 0;  // bit 3 j + i: takes part in the node's second field
    };
    struct Nodes {  // a velocity field's, by node; nothing where there is no second field
        NodeBox box;
        std::vector<double> volume, per_volume;  // [m2], [1/m2]
        std::vector<double> right, up;           // what passes to the next node [m2]
        std::vector<Deviator> value, next;
    };
    template <class Value>
    void each_node(const Weight& w, std::vector<Value> Nodes::*values, auto f);
    void start(Nodes& nodes, const Field& field) const;
    void weigh_point(const Points& points, std::size_t p, bool near, const Grid& grid);
    void link(Nodes& nodes) const;
    void unlink(const Grid& grid);
    void smooth(Nodes& nodes) const;
    void smooth_row(Nodes& nodes, int j) const;

    double share_ = 0;  // of each of four neighbours in a pass
    int passes_ = 0;
    GridShape shape_;
    std::vector<Weight> weight_;
    std::vector<double> volume_;  // by point [m2]
    std::array<Nodes, 2> nodes_;
};

}  // namespace sandgraph::mpm
