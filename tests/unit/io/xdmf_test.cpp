#include "io/xdmf.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstring>
#include <regex>

#include "base/process.hpp"
#include "io/h5_dataset.hpp"
#include "io/h5_file.hpp"
#include "io/run_file.hpp"
#include "tests/unit/io/scratch.hpp"

namespace sandgraph::io {
namespace {

using test::Scratch;

void write_run(const Scratch& folder, int frames) {
    RunFile run = RunFile::create(folder.path(), {"", "0", "0.1", "", "full", 1});
    for (int k = 0; k < frames; ++k)
        run.append(Frame{0.5 * k,
                         0.1 * k,
                         0,
                         1,
                         {0, 1, 2},
                         {3, 4, 5},
                         {{"displacement", "m", 2, std::vector<double>(6, k), plane_vector},
                          {"F", "-", 4, std::vector<double>(12, k), "xx xy yx yy"},
                          {"q < 15 & \"p\"", "Pa", 1, {1, 2, 3}}}});
}

// Every element closes in order (the subset of XML the writer uses); returns the number of elements.
int count_well_formed(const std::string& xml) {
    const std::regex tag(R"(<(/?)([A-Za-z]+)((?:\s+[A-Za-z]+="[^"<]*")*)\s*(/?)>)");
    std::vector<std::string> open;
    int count = 0;
    for (std::sregex_iterator it(xml.begin(), xml.end(), tag), end; it != end; ++it, ++count) {
        if ((*it)[1].length() > 0) {
            EXPECT_FALSE(open.empty() || open.back() != (*it)[2]) << it->str();
            if (!open.empty()) open.pop_back();
        } else if ((*it)[4].length() == 0) {
            open.push_back((*it)[2]);
        }
    }
    EXPECT_TRUE(open.empty());
    return count;
}

std::string unescaped(std::string text) {
    for (const auto& [from, to] : {std::pair{"&lt;", "<"}, {"&gt;", ">"}, {"&quot;", "\""}, {"&amp;", "&"}})
        for (std::size_t at; (at = text.find(from)) != std::string::npos;)
            text.replace(at, std::strlen(from), to);
    return text;
}

TEST(Xdmf, EveryReferenceExistsWithItsDimensions) {
    const Scratch folder;
    write_run(folder, 3);
    const std::string xml = test::contents(folder / "fields.xdmf");
    const std::regex item(R"re(<DataItem Dimensions="([0-9 ]+)"[^>]*>([^:<]+):([^<]+)</DataItem>)re");
    int references = 0;
    for (std::sregex_iterator it(xml.begin(), xml.end(), item), end; it != end; ++it, ++references) {
        const h5::File file = h5::File::open(folder / (*it)[2]);
        std::ostringstream dimensions;
        for (const std::size_t n : h5::shape(file.root(), unescaped((*it)[3]).substr(1)))
            dimensions << (dimensions.tellp() > 0 ? " " : "") << n;
        EXPECT_EQ(dimensions.str(), (*it)[1]) << (*it)[3];
    }
    EXPECT_EQ(references, 3 * (1 + 1 + 3));  // vertices, positions, fields
}

TEST(Xdmf, IsWellFormedXmlWithOneTimeAFrame) {
    const Scratch folder;
    write_run(folder, 2);
    const std::string xml = test::contents(folder / "fields.xdmf");
    EXPECT_GT(count_well_formed(xml), 20);
    EXPECT_NE(xml.find("<Time Value=\"0\"/>"), std::string::npos);
    EXPECT_NE(xml.find("<Time Value=\"0.5\"/>"), std::string::npos);
    EXPECT_NE(xml.find("CollectionType=\"Temporal\""), std::string::npos);
    EXPECT_NE(xml.find("TopologyType=\"Polyvertex\" NumberOfElements=\"3\""), std::string::npos);
    EXPECT_NE(xml.find("GeometryType=\"XY\""), std::string::npos);
    EXPECT_NE(xml.find("Name=\"q &lt; 15 &amp; &quot;p&quot;\""), std::string::npos);
}

std::string attribute_type(const std::string& xml, const std::string& name) {
    std::smatch found;
    const std::regex type("<Attribute Name=\"" + name + "\" AttributeType=\"([A-Za-z]+)\"");
    return std::regex_search(xml, found, type) ? found[1].str() : "none";
}

// ParaView takes an array of three components for a vector, and no other.
TEST(Xdmf, VectorsHaveThreeComponentsInTheFileAndTwoInMemory) {
    const Scratch folder;
    write_run(folder, 2);
    const std::string xml = test::contents(folder / "fields.xdmf");
    EXPECT_EQ(attribute_type(xml, "displacement"), "Vector");
    EXPECT_EQ(attribute_type(xml, "F"), "Matrix");
    {
        const h5::File file = h5::File::open(folder / "run.h5");
        const h5::Group frame = file.root().open("frames").open("0001");
        EXPECT_EQ(h5::shape(frame, "displacement"), (h5::Shape{3, 3}));
        EXPECT_EQ(h5::read<double>(frame, "displacement"), (std::vector<double>{1, 1, 0, 1, 1, 0, 1, 1, 0}));
    }
    const Frame read = read_run_frame(folder / "run.h5", 1);
    const auto displacement = std::ranges::find(read.fields, "displacement", &Field::name);
    ASSERT_NE(displacement, read.fields.end());
    EXPECT_EQ(displacement->components, 2);
    EXPECT_EQ(displacement->values, std::vector<double>(6, 1));
}

// Readers built on the Xdmf3 library make no cells of a topology without its list.
TEST(Xdmf, ListsTheVerticesOfItsTopology) {
    const Scratch folder;
    write_run(folder, 1);
    const std::string xml = test::contents(folder / "fields.xdmf");
    const std::size_t begin = xml.find("<Topology"), end = xml.find("</Topology>");
    ASSERT_NE(end, std::string::npos);
    EXPECT_NE(xml.substr(begin, end - begin).find("run.h5:/points/id"), std::string::npos);
    const h5::File file = h5::File::open(folder / "run.h5");
    EXPECT_EQ(h5::read<std::int32_t>(file.root().open("points"), "id"), (std::vector<std::int32_t>{0, 1, 2}));
}

// All three of its readers, if it is there: points, as many cells, and vectors.
TEST(ParaView, OpensTheFieldsInAllItsReaders) {
    const Scratch folder;
    write_run(folder, 2);
    test::overwrite(folder / "look.py", R"(import os
from paraview import simple as s
for make in (lambda f: s.XDMFReader(FileNames=[f]), lambda f: s.Xdmf3ReaderS(FileName=[f]),
             lambda f: s.Xdmf3ReaderT(FileName=[f])):
    r = make(os.path.abspath('fields.xdmf')); r.UpdatePipeline(); r.UpdatePipeline(r.TimestepValues[-1])
    i = r.GetDataInformation(); a = r.PointData.GetArray('displacement')
    print(len(r.TimestepValues), i.GetNumberOfPoints(), i.GetNumberOfCells(), a.GetNumberOfComponents())
)");
    const int status = run_program({"pvpython", "look.py"}, folder.path(), folder / "messages");
    if (status == program_missing) GTEST_SKIP() << "no pvpython";
    EXPECT_EQ(test::contents(folder / "messages"), "2 3 3 3\n2 3 3 3\n2 3 3 3\n");
}

}  // namespace
}  // namespace sandgraph::io
