#include <gtest/gtest.h>

#include "surrogate/load_surrogate.hpp"

namespace sandgraph::surrogate {
namespace {

// Loading checks file, features, self test and physics: a change of the equations that leaves the shipped
// weights behind shows here.
TEST(ShippedModel, IsAcceptedByThisVersion) {
    EXPECT_NO_THROW(load_surrogate(std::string(SANDGRAPH_SOURCE) + "/configs/models/table1.surrogate.h5"));
}

}  // namespace
}  // namespace sandgraph::surrogate
