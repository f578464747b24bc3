#include "dem/time_step.hpp"

#include <gtest/gtest.h>

#include <vector>

namespace sandgraph::dem {
namespace {

TEST(PreparationStep, IsTheUsualOneOfUsualGrainsAndStaysStableForOthers) {
    const std::vector<double> usual{0.003, 0.007}, small{0.0003, 0.0007};
    EXPECT_EQ(preparation_time_step({}, usual), 1e-5);
    Material stiff;
    stiff.young *= 20;
    EXPECT_LT(preparation_time_step(stiff, usual), 0.5 * critical_time_step(stiff, usual));
    EXPECT_LT(preparation_time_step({}, small), 0.5 * critical_time_step({}, small));
}

}  // namespace
}  // namespace sandgraph::dem
