#pragma once
#include <vector>

#include "base/byte_stream.hpp"
#include "base/tensor.hpp"

namespace sandgraph::graph {

// The deformation history of a point, F(path) with its spin, kept as a piecewise linear path of few knots:
// what a packing must be driven along to stand where its point stands. Of the path not yet driven, every
// point added lies within error() of it (Frobenius norm of F), in order, so that reversals larger than that
// survive. Memory is bounded: when knots_max are in use the tolerance doubles and knots are merged.
class StrainPath {
  public:
    static constexpr std::size_t knots_max = 64;
    explicit StrainPath(double tolerance = 1e-5) : tolerance_(tolerance) {}

    void begin(const Mat2& F);  // forgets what was: a packing stands where its point does, at F
    void add(const Mat2& F);    // the point has got to F (total, det > 0)
    // Drives on along the path by at most `budget` of strain (Hencky norm), at most to the next knot:
    // returns the increment. Identity when there is nothing left.
    Mat2 advance(double budget);
    // How far a copy of this path has been driven.
    struct Place {
        Mat2 driven = Mat2::Identity();
        std::uint32_t knots = 0;  // ahead of it
    };
    Place place() const { return {driven_, static_cast<std::uint32_t>(knots_.size())}; }
    // As advancing has brought a copy there that was as this one is.
    void follow(const Place& place);
    bool done() const { return knots_.empty() && driven_ == latest_; }
    const Mat2& driven() const { return driven_; }  // how far a packing has been driven
    const Mat2& latest() const { return latest_; }
    std::size_t knots() const { return knots_.size(); }
    double error() const { return 2 * tolerance_; }
    void clear();  // forgets the path and frees its memory: nobody will drive it

    void save(ByteWriter& out) const;
    void load(ByteReader& in);

  private:
    void extend(const Mat2& F);
    bool near_chord(const Mat2& end) const;
    const Mat2& last_knot() const { return knots_.empty() ? driven_ : knots_.back(); }
    void merge();

    double tolerance_;
    Mat2 driven_ = Mat2::Identity(), latest_ = Mat2::Identity();
    std::vector<Mat2> knots_;   // ahead of driven_
    std::vector<Mat2> recent_;  // passed since the last knot
};

// Norm of the strain of a small increment: of ln U in F = R U.
double strain_norm(const Mat2& F_inc);

}  // namespace sandgraph::graph
