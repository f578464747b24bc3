#include "dem/packing/packing.hpp"

namespace sandgraph::dem {

double porosity(const Packing& packing) {
    double solid = 0;
    for (double r : packing.r) solid += std::numbers::pi * r * r;
    return 1 - solid / packing.area();
}

}  // namespace sandgraph::dem
