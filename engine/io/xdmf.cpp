#include "io/xdmf.hpp"

#include <fmt/format.h>

#include <numeric>
#include <string>
#include <vector>

#include "base/text.hpp"
#include "io/atomic_file.hpp"
#include "io/frame.hpp"
#include "io/h5_attribute.hpp"
#include "io/h5_dataset.hpp"
#include "io/h5_file.hpp"

namespace sandgraph::io {
namespace {

constexpr const char* kPoints = "points";
constexpr const char* kId = "id";
constexpr const char* kReal = R"(NumberType="Float" Precision="8")";
constexpr const char* kInteger = R"(NumberType="Int" Precision="4")";

std::string data_item(const std::string& file, const h5::Group& group, const std::string& name,
                      const char* type) {
    std::string dimensions;
    for (const std::size_t n : h5::shape(group, name))
        dimensions += fmt::format("{}{}", dimensions.empty() ? "" : " ", n);
    return fmt::format(R"(<DataItem Dimensions="{}" {} Format="HDF">{}:{}</DataItem>)", dimensions, type,
                       xml_escaped(file), xml_escaped(group.path_of(name)));
}

const char* attribute_type(const h5::Group& frame, const std::string& name) {
    if (h5::shape(frame, name).size() == 1) return "Scalar";
    const bool vector = h5::has_attribute(frame, name, "components") &&
                        h5::get_text(frame, name, "components") == plane_vector;
    return vector ? "Vector" : "Matrix";
}

std::string attribute(const std::string& file, const h5::Group& frame, const std::string& name) {
    return fmt::format(
        "        <Attribute Name=\"{}\" AttributeType=\"{}\" Center=\"Node\">\n          {}\n        "
        "</Attribute>\n",
        xml_escaped(name), attribute_type(frame, name), data_item(file, frame, name, kReal));
}

std::string grid(const std::string& file, const h5::Group& points, const h5::Group& frame,
                 const std::string& name) {
    std::string text =
        fmt::format("      <Grid Name=\"frame {}\" GridType=\"Uniform\">\n        <Time Value=\"{}\"/>\n",
                    name, h5::get_real(frame, ".", "time"));
    text += fmt::format(
        "        <Topology TopologyType=\"Polyvertex\" NumberOfElements=\"{}\" NodesPerElement=\"1\">\n"
        "          {}\n        </Topology>\n",
        h5::shape(frame, "position").front(), data_item(file, points, kId, kInteger));
    text += fmt::format("        <Geometry GeometryType=\"XY\">\n          {}\n        </Geometry>\n",
                        data_item(file, frame, "position", kReal));
    for (const std::string& field : frame.names())
        if (field != "position") text += attribute(file, frame, field);
    return text + "      </Grid>\n";
}

}  // namespace

void write_point_ids(h5::Group root) {
    const h5::Group frames = root.open("frames");
    if (frames.names().empty()) return;
    std::vector<std::int32_t> ids(h5::shape(frames.open(frames.names().front()), "position").front());
    std::iota(ids.begin(), ids.end(), 0);
    h5::Group group = root.create(kPoints);
    h5::write(group, kId, std::span<const std::int32_t>(ids), {ids.size()});
}

void write_xdmf(const std::filesystem::path& xdmf, const std::filesystem::path& run_h5) {
    const h5::File file = h5::File::open(run_h5);
    const h5::Group frames = file.root().open("frames");
    std::string text =
        "<?xml version=\"1.0\" encoding=\"utf-8\"?>\n<Xdmf Version=\"3.0\">\n  <Domain>\n"
        "    <Grid Name=\"ground\" GridType=\"Collection\" CollectionType=\"Temporal\">\n";
    for (const std::string& name : frames.names())
        text += grid(run_h5.filename().string(), file.root().open(kPoints), frames.open(name), name);
    write_text(xdmf, text + "    </Grid>\n  </Domain>\n</Xdmf>\n");
}

}  // namespace sandgraph::io
