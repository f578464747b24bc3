#include "io/xdmf.hpp"

#include <fmt/format.h>

#include <iterator>
#include <string>

#include "base/text.hpp"
#include "io/atomic_file.hpp"
#include "io/h5_attribute.hpp"
#include "io/h5_dataset.hpp"
#include "io/h5_file.hpp"

namespace sandgraph::io {
namespace {

std::string data_item(const std::string& file, const h5::Group& frame, const std::string& name) {
    std::string dimensions;
    for (const std::size_t n : h5::shape(frame, name))
        dimensions += fmt::format("{}{}", dimensions.empty() ? "" : " ", n);
    return fmt::format(
        R"(<DataItem Dimensions="{}" NumberType="Float" Precision="8" Format="HDF">{}:{}</DataItem>)",
        dimensions, xml_escaped(file), xml_escaped(frame.path_of(name)));
}

std::string attribute(const std::string& file, const h5::Group& frame, const std::string& name) {
    const h5::Shape shape = h5::shape(frame, name);
    const char* type = shape.size() == 1 ? "Scalar" : "Matrix";
    return fmt::format(
        "        <Attribute Name=\"{}\" AttributeType=\"{}\" Center=\"Node\">\n          {}\n        "
        "</Attribute>\n",
        xml_escaped(name), type, data_item(file, frame, name));
}

std::string grid(const std::string& file, const h5::Group& frame, const std::string& name) {
    std::string text =
        fmt::format("      <Grid Name=\"frame {}\" GridType=\"Uniform\">\n        <Time Value=\"{}\"/>\n",
                    name, h5::get_real(frame, ".", "time"));
    text += fmt::format(
        "        <Topology TopologyType=\"Polyvertex\" NumberOfElements=\"{}\" NodesPerElement=\"1\"/>\n",
        h5::shape(frame, "position").front());
    text += fmt::format("        <Geometry GeometryType=\"XY\">\n          {}\n        </Geometry>\n",
                        data_item(file, frame, "position"));
    for (const std::string& field : frame.names())
        if (field != "position") text += attribute(file, frame, field);
    return text + "      </Grid>\n";
}

}  // namespace

void write_xdmf(const std::filesystem::path& xdmf, const std::filesystem::path& run_h5) {
    const h5::File file = h5::File::open(run_h5);
    const h5::Group frames = file.root().open("frames");
    std::string text =
        "<?xml version=\"1.0\" encoding=\"utf-8\"?>\n<Xdmf Version=\"3.0\">\n  <Domain>\n"
        "    <Grid Name=\"ground\" GridType=\"Collection\" CollectionType=\"Temporal\">\n";
    for (const std::string& name : frames.names())
        text += grid(run_h5.filename().string(), frames.open(name), name);
    write_text(xdmf, text + "    </Grid>\n  </Domain>\n</Xdmf>\n");
}

}  // namespace sandgraph::io
