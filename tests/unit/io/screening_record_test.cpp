#include "io/screening_record.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "io/h5_dataset.hpp"
#include "io/h5_file.hpp"
#include "scratch.hpp"

namespace sandgraph::io {
namespace {

// A hand-over in the last step has no step after it.
TEST(ScreeningRecord, WhatNeverHappenedIsNoNaNInTheFile) {
    const test::Scratch folder;
    ScreeningRecord record{{"none", "strain"}, {}, {}};
    record.switches.resize(2);
    record.switches[0].felt = 0.1, record.switches[0].ordinary = 0.02;
    h5::File file = h5::File::create(folder / "s.h5");
    h5::Group root = file.root();
    write_screening(root, record);
    EXPECT_EQ(h5::read<double>(root.open("switches"), "felt"), (std::vector<double>{0.1, -1}));
    EXPECT_EQ(h5::read<double>(root.open("switches"), "ordinary"), (std::vector<double>{0.02, -1}));
    const ScreeningRecord again = read_screening(root);
    ASSERT_EQ(again.switches.size(), 2u);
    EXPECT_EQ(again.switches[0].ordinary, 0.02);
    EXPECT_TRUE(std::isnan(again.switches[1].felt) && std::isnan(again.switches[1].ordinary));
}

}  // namespace
}  // namespace sandgraph::io
