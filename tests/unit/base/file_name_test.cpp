#include "base/file_name.hpp"

#include <gtest/gtest.h>

#include "base/error.hpp"

namespace sandgraph {
namespace {

TEST(FileName, TellsItsKindInAnyCase) {
    EXPECT_EQ(extension_of("out.d/P.CSV"), ".csv");
    EXPECT_EQ(extension_of("out.d/P"), "");
    EXPECT_EQ(extension_of("a.card.json"), ".json");
}

TEST(FileName, OfAnotherKindIsRefused) {
    EXPECT_THROW(require_extension("x.png", ".csv"), InputError);
    EXPECT_THROW(require_extension("X.H5", ".csv"), InputError);
    for (const char* name : {"", "x", "x.csv", "X.CSV", "x.txt", "out/case.v2"})
        EXPECT_NO_THROW(require_extension(name, ".csv")) << name;
}

// Readers go by the name of a packing.
TEST(FileName, MustBeRightWhereReadersGoByIt) {
    for (const char* name : {"p", "p.csv", "p.txt"})
        EXPECT_THROW(require_extension(name, ".h5", Naming::always), InputError) << name;
    EXPECT_NO_THROW(require_extension("p.h5", ".h5", Naming::always));
    EXPECT_NO_THROW(require_extension("", ".h5", Naming::always));
}

}  // namespace
}  // namespace sandgraph
