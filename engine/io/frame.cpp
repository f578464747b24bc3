#include "io/frame.hpp"

#include <fmt/format.h>

#include <stdexcept>

#include "io/h5_attribute.hpp"
#include "io/h5_dataset.hpp"

namespace sandgraph::io {
namespace {

constexpr const char* position = "position";

std::vector<double> interleaved(const Frame& frame) {
    std::vector<double> xy;
    xy.reserve(2 * frame.x.size());
    for (std::size_t p = 0; p < frame.x.size(); ++p) xy.insert(xy.end(), {frame.x[p], frame.y[p]});
    return xy;
}

bool is_plane_vector(const Field& field) { return field.component_names == plane_vector; }

std::vector<double> with_third(const std::vector<double>& xy) {
    std::vector<double> xyz;
    xyz.reserve(xy.size() / 2 * 3);
    for (std::size_t k = 0; k + 1 < xy.size(); k += 2) xyz.insert(xyz.end(), {xy[k], xy[k + 1], 0});
    return xyz;
}

std::vector<double> without_third(const std::vector<double>& xyz) {
    std::vector<double> xy;
    xy.reserve(xyz.size() / 3 * 2);
    for (std::size_t k = 0; k + 2 < xyz.size(); k += 3) xy.insert(xy.end(), {xyz[k], xyz[k + 1]});
    return xy;
}

void write_field(h5::Group& group, const Field& field, std::size_t points) {
    const auto components = static_cast<std::size_t>(field.components);
    if (field.values.size() != components * points || field.name == position)
        throw std::logic_error(
            fmt::format("field {}: {} values, {} points", field.name, field.values.size(), points));
    const bool in_plane = is_plane_vector(field) && components == 2;
    const std::vector<double> spatial = in_plane ? with_third(field.values) : std::vector<double>();
    h5::Shape shape{points};
    if (components > 1) shape.push_back(in_plane ? 3 : components);
    h5::write(group, field.name, std::span<const double>(in_plane ? spatial : field.values), shape,
              field.unit);
    if (!field.component_names.empty())
        h5::set_attribute(group, field.name, "components", field.component_names);
    if (!field.codes.empty()) h5::set_attribute(group, field.name, "values", field.codes);
}

std::string text_or_none(const h5::Group& group, const std::string& name, const char* attribute) {
    return h5::has_attribute(group, name, attribute) ? h5::get_text(group, name, attribute) : "";
}

Field read_field(const h5::Group& group, const std::string& name) {
    const h5::Shape shape = h5::shape(group, name);
    Field field{name,
                text_or_none(group, name, "unit"),
                shape.size() > 1 ? static_cast<int>(shape[1]) : 1,
                h5::read<double>(group, name),
                text_or_none(group, name, "components"),
                text_or_none(group, name, "values")};
    if (is_plane_vector(field) && field.components == 3)
        field.values = without_third(field.values), field.components = 2;
    return field;
}

}  // namespace

std::string frame_name(std::size_t index) { return fmt::format("{:04}", index); }

void write_frame(h5::Group group, const Frame& frame) {
    if (frame.x.size() != frame.y.size()) throw std::logic_error("frame: x and y differ in length");
    h5::set_attribute(group, ".", "time", frame.time);
    h5::set_attribute(group, ".", "d_over_B", frame.d_over_B);
    h5::set_attribute(group, ".", "plate_x", frame.plate_x);
    h5::set_attribute(group, ".", "plate_y", frame.plate_y);
    h5::write(group, position, std::span<const double>(interleaved(frame)), {frame.x.size(), 2}, "m");
    for (const Field& field : frame.fields) write_field(group, field, frame.x.size());
}

Frame read_frame(const h5::Group& group) {
    Frame frame{h5::get_real(group, ".", "time"),
                h5::get_real(group, ".", "d_over_B"),
                h5::get_real(group, ".", "plate_x"),
                h5::get_real(group, ".", "plate_y"),
                {},
                {},
                {}};
    const std::vector<double> xy = h5::read<double>(group, position);
    for (std::size_t k = 0; k + 1 < xy.size(); k += 2) {
        frame.x.push_back(xy[k]);
        frame.y.push_back(xy[k + 1]);
    }
    for (const std::string& name : group.names())
        if (name != position) frame.fields.push_back(read_field(group, name));
    return frame;
}

}  // namespace sandgraph::io
