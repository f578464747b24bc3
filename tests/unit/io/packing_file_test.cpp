#include "io/packing_file.hpp"

#include <gtest/gtest.h>

#include <functional>
#include <limits>

#include "base/error.hpp"
#include "tests/unit/io/scratch.hpp"

namespace sandgraph::io {
namespace {

using test::Scratch;

PackingRecord record() {
    PackingRecord r;
    r.packing.H << 0.2, 0.013, 0, 0.1;
    r.packing.L << 0.1, 0.3, 0, -0.1;
    r.packing.x = {0.01, 0.0195, 0.1}, r.packing.y = {0.02, 0.02, 0.05}, r.packing.r = {0.005, 0.005, 0.003};
    r.packing.vx = {1e-3, -2e-3, 0}, r.packing.vy = {0, 0.1, 0}, r.packing.spin = {0.5, -0.25, 1.0 / 3};
    r.packing.contacts = {{0, 1, 0, 0, 12.5, -1e-4}, {1, 2, -1, 1, 0.1, 0}};
    r.material.friction_angle = 0.3;
    r.material.rolling_form = dem::RollingForm::total;
    r.recipe = "density = \"dense\"\nseed = 1\n";
    return r;
}

TEST(PackingFile, ReadsBackTheSameBits) {
    const Scratch folder;
    const PackingRecord written = record();
    write_packing(folder / "p.h5", written);
    const PackingRecord read = read_packing(folder / "p.h5");
    EXPECT_EQ(read.packing.H, written.packing.H);
    EXPECT_EQ(read.packing.L, written.packing.L);
    EXPECT_EQ(read.packing.x, written.packing.x);
    EXPECT_EQ(read.packing.y, written.packing.y);
    EXPECT_EQ(read.packing.r, written.packing.r);
    EXPECT_EQ(read.packing.spin, written.packing.spin);
    ASSERT_EQ(read.packing.contacts.size(), 2u);
    EXPECT_EQ(read.packing.contacts[1].cell_x, -1);
    EXPECT_EQ(read.packing.contacts[0].tangential, 12.5);
    EXPECT_EQ(read.packing.contacts[0].moment, -1e-4);
    EXPECT_EQ(read.material.friction_angle, 0.3);
    EXPECT_EQ(read.material.rolling_form, dem::RollingForm::total);
    EXPECT_EQ(read.recipe, written.recipe);
}

TEST(PackingFile, AtRestStaysAtRest) {
    const Scratch folder;
    PackingRecord r = record();
    r.packing.vx.clear(), r.packing.vy.clear(), r.packing.spin.clear(), r.packing.contacts.clear();
    write_packing(folder / "p.h5", r);
    EXPECT_TRUE(read_packing(folder / "p.h5").packing.vx.empty());
    EXPECT_TRUE(read_packing(folder / "p.h5").packing.contacts.empty());
}

TEST(PackingFile, RefusesWhatIsNoPacking) {
    const double nan = std::numeric_limits<double>::quiet_NaN();
    const std::vector<std::function<void(PackingRecord&)>> spoilers{
        [&](PackingRecord& r) { r.packing.x[1] = nan; },
        [](PackingRecord& r) { r.packing.r[0] = 0; },
        [](PackingRecord& r) { r.packing.r[0] = -0.005; },
        [](PackingRecord& r) { r.packing.y.pop_back(); },
        [](PackingRecord& r) { r.packing.spin.push_back(0); },
        [&](PackingRecord& r) { r.packing.vy[2] = nan; },
        [](PackingRecord& r) { r.packing.H.col(0).swap(r.packing.H.col(1)); },
        [](PackingRecord& r) { r.packing.H.setZero(); },
        [&](PackingRecord& r) { r.packing.L(0, 1) = nan; },
        [](PackingRecord& r) { r.packing.contacts[0].j = 3; },
        [](PackingRecord& r) { r.packing.contacts[0].i = -1; },
        [](PackingRecord& r) { r.packing.contacts[0].j = 0; },
        [&](PackingRecord& r) { r.packing.contacts[1].moment = nan; },
        [](PackingRecord& r) { r.material.young = 0; },
        [](PackingRecord& r) { r.material.damping = 1.5; },
        [&](PackingRecord& r) { r.material.density = nan; },
    };
    const Scratch folder;
    for (std::size_t k = 0; k < spoilers.size(); ++k) {
        PackingRecord r = record();
        spoilers[k](r);
        write_packing(folder / "p.h5", r);
        const std::string message = test::message_of<InputError>([&] { read_packing(folder / "p.h5"); });
        EXPECT_NE(message.find("p.h5"), std::string::npos) << k;
        EXPECT_EQ(message.find('\n'), std::string::npos) << k;
    }
}

TEST(PackingFile, RefusesTruncatedFiles) {
    const Scratch folder;
    write_packing(folder / "p.h5", record());
    const std::string whole = test::contents(folder / "p.h5");
    for (std::size_t size = 0; size < whole.size(); size += whole.size() / 20) {
        test::overwrite(folder / "cut.h5", whole.substr(0, size));
        EXPECT_THROW(read_packing(folder / "cut.h5"), InputError) << size;
    }
}

}  // namespace
}  // namespace sandgraph::io
