#include "io/info.hpp"

#include <gtest/gtest.h>

#include "base/error.hpp"
#include "io/checkpoint.hpp"
#include "io/h5_file.hpp"
#include "io/packing_file.hpp"
#include "io/run_file.hpp"
#include "tests/unit/io/scratch.hpp"

namespace sandgraph::io {
namespace {

using test::Scratch;

void expect_in(const std::string& text, std::initializer_list<const char*> parts) {
    for (const char* part : parts)
        EXPECT_NE(text.find(part), std::string::npos) << part << " not in\n" << text;
}

TEST(Info, ShowsGroupsShapesUnitsAndAttributesOfARun) {
    const Scratch folder;
    RunFile run =
        RunFile::create(folder.path(), {"[domain]\nwidth = \"6 m\"\n", "cafe", "0.1", "git1", "full", 2});
    run.append(LoadRow{});
    run.append(
        Frame{0,
              0,
              0,
              1,
              {0, 1},
              {2, 3},
              {{"displacement", "m", 2, {1, 2, 3, 4}}, {"mode", "-", 1, {0, 1}, "", "surrogate replay"}}});
    const std::string text = info(folder / "run.h5");
    expect_in(text,
              {"content = \"run\"", "schema = 1", "load/", "[N/m]", "frames/", "0000/", "float64 (2 x 2) [m]",
               "[-] (surrogate replay)", "hash = \"cafe\"", "threads = 2", "text = \"[domain]...\""});
}

TEST(Info, ShowsAPackingAndChecksACheckpoint) {
    const Scratch folder;
    PackingRecord record;
    record.packing.H = 0.1 * Mat2::Identity();
    record.packing.x = {0.05}, record.packing.y = {0.05}, record.packing.r = {0.005};
    write_packing(folder / "p.h5", record);
    expect_in(info(folder / "p.h5"),
              {"content = \"packing\"", "grains/", "float64 (1) [m]", "rolling_limit = 0.05"});

    CheckpointWriter writer(folder / "c.h5", {"cafe", "git1", 0.1});
    std::vector<double> values{1, 2};
    writer.field("points/x", values);
    writer.commit();
    expect_in(info(folder / "c.h5"),
              {"checksum verified", "content = \"checkpoint\"", "scene_hash = \"cafe\""});
    std::string bytes = test::contents(folder / "c.h5");
    bytes[20] ^= 1;
    test::overwrite(folder / "c.h5", bytes);
    EXPECT_THROW(info(folder / "c.h5"), InputError);
}

// Each level holds the root eight times: 8^16 objects to whoever follows every link.
TEST(Info, EndsThoughGroupsHoldThemselves) {
    const Scratch folder;
    {
        h5::File file = h5::File::create(folder / "a.h5");
        h5::Group root = file.root();
        for (const char* name : {"a", "b", "c", "d", "e", "f", "g", "h"})
            H5Lcreate_hard(root.id(), "/", root.id(), name, H5P_DEFAULT, H5P_DEFAULT);
        file.close();
    }
    expect_in(info(folder / "a.h5"), {"  a/", "..."});
}

}  // namespace
}  // namespace sandgraph::io
