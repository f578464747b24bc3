#pragma once
#include <string>
#include <vector>

#include "base/tensor.hpp"
#include "io/frame.hpp"

namespace sandgraph::results {

// What a field picture shows. Frames carry the fields "displacement" (2 components) [m], "F" (4: xx, xy, yx,
// yy) and "porosity" (1); those of a screening run also "mode" (1), the constitutive mode of a point.
enum class Quantity { displacement, equivalent_strain, rotation, porosity, mode };

// One value per material point, ready to be coloured.
struct PointValues {
    std::string name;            // e.g. "rotation", as gnuplot's enhanced text
    std::string unit;            // e.g. "deg"; "-" if none
    bool is_signed = false;      // diverging colours, centred at zero
    std::vector<double> values;  // NaN: not drawn
    // Of values that are places in a list: what each stands for. Such have one colour each, in every frame.
    std::vector<std::string> kinds = {};
};

// InputError when the frame lacks the field the quantity is made from.
PointValues point_values(const io::Frame& frame, Quantity quantity);

bool has_field(const io::Frame& frame, const std::string& name);
const io::Field& field(const io::Frame& frame, const std::string& name, int components);
Mat2 deformation_gradient(const io::Field& F, std::size_t point);

}  // namespace sandgraph::results
