#pragma once
#include <utility>
#include <vector>

#include "base/byte_stream.hpp"
#include "base/tensor.hpp"
#include "graph/plane_moduli.hpp"
#include "graph/stress_arithmetic.hpp"

namespace sandgraph::graph {

// The plastic part of predictions: by how much the last answers of a point fell short of its elastic stress,
// per strain along the way that it was going. It holds where the point gets further that way than ever; a
// reversal is elastic, and so is the way back to where it turned: what shakes to and fro gains no energy.
// docs/how_it_works.md (eqs. 29a and 31a).
class Secants {
  public:
    explicit Secants(std::size_t points) : all_(points) {}

    // What the increment takes off the elastic prediction [Pa], tension positive.
    Stress shortfall(std::size_t point, const Mat2& F_inc);
    // The same of a strain to come, by one to whom nothing has happened yet.
    Stress shortfall_ahead(std::size_t point, const Stress& strain) const;
    // The law's answer to the deformation collected since its last one lay so far beyond the prediction [Pa].
    void learn(std::size_t point, const Mat2& collected, const Stress& beyond, const PlaneModuli& moduli);
    void learn_nothing(std::size_t point) { all_[point].progress = all_[point].travel = 0; }
    void forget(std::size_t point) { all_[point] = {}; }

    void save(ByteWriter& out) const { out.put(all_); }
    void load(ByteReader& in);

  private:
    struct Secant {
        Stress way;           // mean direction of the strain, Frobenius norm 1; 0: none known
        Stress slope;         // shortfall per strain along it [Pa]
        double position = 0;  // strain along it from the furthest point reached, at most 0
        double progress = 0;  // of the furthest point since the last answer
        double travel = 0;    // length of the strain path since the last answer
    };
    std::vector<Secant> all_;
};

// Here to be inlined: it runs for every point at every step.
inline Stress Secants::shortfall(std::size_t point, const Mat2& F_inc) {
    Secant& q = all_[point];
    const Stress e = small_strain(F_inc);
    q.travel += norm(e);
    q.position += product(q.way, e);
    if (!(q.position > 0)) return {};
    const double gained = std::exchange(q.position, 0.0);
    q.progress += gained;
    return scaled(gained, q.slope);
}

}  // namespace sandgraph::graph
