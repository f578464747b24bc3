#include "io/h5_dataset.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstdint>
#include <numeric>

#include "base/contracts.hpp"
#include "io/h5_attribute.hpp"

namespace sandgraph::io::h5 {
namespace {

template <class T>
hid_t native();
template <>
hid_t native<double>() {
    return H5T_NATIVE_DOUBLE;
}
template <>
hid_t native<float>() {
    return H5T_NATIVE_FLOAT;
}
template <>
hid_t native<std::int64_t>() {
    return H5T_NATIVE_INT64;
}
template <>
hid_t native<std::int32_t>() {
    return H5T_NATIVE_INT32;
}
template <>
hid_t native<std::int16_t>() {
    return H5T_NATIVE_INT16;
}
template <>
hid_t native<std::uint8_t>() {
    return H5T_NATIVE_UINT8;
}

constexpr hsize_t chunk_rows = 4096;

std::size_t product(const Shape& shape) {
    return std::accumulate(shape.begin(), shape.end(), std::size_t{1}, std::multiplies<>());
}

std::vector<hsize_t> to_hsize(const Shape& shape) { return {shape.begin(), shape.end()}; }

Handle dataspace(const Shape& shape, Storage storage, const Group& group) {
    const std::vector<hsize_t> now = to_hsize(shape);
    std::vector<hsize_t> most = now;
    if (storage == Storage::growing) most.front() = H5S_UNLIMITED;
    return own(H5Screate_simple(static_cast<int>(now.size()), now.data(), most.data()), H5Sclose,
               group.file(), "describe a dataset");
}

Handle creation(const Shape& shape, Storage storage) {
    Handle list = own(H5Pcreate(H5P_DATASET_CREATE), H5Pclose, "HDF5", "create a property list");
    const bool empty = std::find(shape.begin(), shape.end(), 0u) != shape.end();
    if (storage == Storage::contiguous || (empty && storage != Storage::growing)) return list;
    std::vector<hsize_t> chunk = to_hsize(shape);
    chunk.front() = storage == Storage::growing ? chunk_rows : std::min(chunk.front(), chunk_rows);
    H5Pset_chunk(list.get(), static_cast<int>(chunk.size()), chunk.data());
    H5Pset_shuffle(list.get());
    H5Pset_deflate(list.get(), 1);
    H5Pset_fletcher32(list.get());
    return list;
}

// No file of ours keeps numbers in another one, which may have no end (/dev/zero); and HDF5 1.10 reads past
// the names of such files when they are damaged, so that it must not open the dataset (both found by
// fuzzing).
void refuse_elsewhere(const Group& group, std::string_view name) {
    constexpr std::uint64_t external_files = std::uint64_t{1} << 7;  // number of the header message
    H5O_info_t info = {};
    if (H5Oget_info_by_name2(group.id(), std::string(name).c_str(), &info, H5O_INFO_HDR, H5P_DEFAULT) >= 0 &&
        !(info.hdr.mesg.present & external_files))
        return;
    refuse(group, "the dataset " + group.path_of(name) + " is damaged or lies in another file", last_error());
}

Handle open_dataset(const Group& group, std::string_view name) {
    if (group.has(name)) refuse_elsewhere(group, name);
    Handle id(
        group.has(name) ? H5Dopen2(group.id(), std::string(name).c_str(), H5P_DEFAULT) : H5I_INVALID_HID,
        H5Dclose);
    if (id.get() < 0) refuse(group, "the dataset " + group.path_of(name) + " is missing", last_error());
    return id;
}

Shape shape_of(const Handle& dataset) {
    const Handle space(H5Dget_space(dataset.get()), H5Sclose);
    std::vector<hsize_t> dims(std::max(0, H5Sget_simple_extent_ndims(space.get())));
    H5Sget_simple_extent_dims(space.get(), dims.data(), nullptr);
    return {dims.begin(), dims.end()};
}

std::string name_of_type(hid_t type) {
    const std::size_t bits = 8 * H5Tget_size(type);
    switch (H5Tget_class(type)) {
        case H5T_FLOAT:
            return fmt::format("float{}", bits);
        case H5T_INTEGER:
            return fmt::format("{}int{}", H5Tget_sign(type) == H5T_SGN_NONE ? "u" : "", bits);
        case H5T_STRING:
            return "text";
        default:
            return "unknown type";
    }
}

template <class T>
void require_type(const Group& group, std::string_view name, const Handle& dataset) {
    const Handle type(H5Dget_type(dataset.get()), H5Tclose);
    const std::string found = name_of_type(type.get()), wanted = name_of_type(native<T>());
    if (found != wanted)
        refuse(group, fmt::format("the dataset {} is {}", group.path_of(name), found), wanted + " expected");
}

// Entries of a dataset about to be read. A file may declare far more than it stores; deflate packs at most
// 1032 to 1, so that what is asked of memory stays in proportion to the file.
std::size_t entries(const Group& group, std::string_view name, const Handle& dataset,
                    std::size_t entry_size) {
    constexpr double most_packed = 1100, fixed = 1 << 20;
    const Shape dims = shape_of(dataset);
    double bytes = static_cast<double>(entry_size);
    for (const std::size_t n : dims) bytes *= static_cast<double>(n);
    if (bytes > most_packed * static_cast<double>(H5Dget_storage_size(dataset.get())) + fixed)
        refuse(group, "the dataset " + group.path_of(name) + " is damaged",
               "it declares more entries than it can hold");
    return product(dims);
}

}  // namespace

template <class T>
void write(Group& group, std::string_view name, std::span<const T> values, const Shape& shape,
           std::string_view unit, Storage storage) {
    SG_EXPECT(!name.empty() && values.size() == product(shape));  // no shape: a scalar
    const std::string label(name);
    const Handle links = own(H5Pcreate(H5P_LINK_CREATE), H5Pclose, group.file(), "create a property list");
    H5Pset_create_intermediate_group(links.get(), 1);
    const Handle id =
        own(H5Dcreate2(group.id(), label.c_str(), native<T>(), dataspace(shape, storage, group).get(),
                       links.get(), creation(shape, storage).get(), H5P_DEFAULT),
            H5Dclose, group.file(), "create the dataset " + group.path_of(name));
    if (!values.empty())
        check(H5Dwrite(id.get(), native<T>(), H5S_ALL, H5S_ALL, H5P_DEFAULT, values.data()), group.file(),
              "write the dataset " + group.path_of(name));
    if (!unit.empty()) set_attribute(group, name, "unit", std::string(unit));
}

template <class T>
void append(Group& group, std::string_view name, std::span<const T> values) {
    if (values.empty()) return;
    const Handle id = open_dataset(group, name);
    const std::string action = "append to " + group.path_of(name);
    std::vector<hsize_t> size = to_hsize(shape_of(id)), count = size, start(size.size(), 0);
    start.at(0) = size[0];
    count[0] = values.size() / std::accumulate(size.begin() + 1, size.end(), hsize_t{1}, std::multiplies<>());
    SG_EXPECT(values.size() == product({count.begin(), count.end()}));  // whole rows
    size[0] += count[0];
    check(H5Dset_extent(id.get(), size.data()), group.file(), action);
    const int axes = static_cast<int>(size.size());
    const Handle memory(H5Screate_simple(axes, count.data(), nullptr), H5Sclose),
        space(H5Dget_space(id.get()), H5Sclose);
    H5Sselect_hyperslab(space.get(), H5S_SELECT_SET, start.data(), nullptr, count.data(), nullptr);
    check(H5Dwrite(id.get(), native<T>(), memory.get(), space.get(), H5P_DEFAULT, values.data()),
          group.file(), action);
}

void truncate(Group& group, std::string_view name, std::size_t size) {
    const Handle id = open_dataset(group, name);
    std::vector<hsize_t> wanted = to_hsize(shape_of(id));
    if (wanted.empty() || wanted[0] < size)
        refuse(group, fmt::format("{} is too short", group.path_of(name)),
               fmt::format("{} entries needed", size));
    wanted[0] = size;
    check(H5Dset_extent(id.get(), wanted.data()), group.file(), "truncate " + group.path_of(name));
}

template <class T>
std::vector<T> read(const Group& group, std::string_view name) {
    const Handle id = open_dataset(group, name);
    require_type<T>(group, name, id);
    std::vector<T> values(entries(group, name, id, sizeof(T)));
    if (!values.empty() && H5Dread(id.get(), native<T>(), H5S_ALL, H5S_ALL, H5P_DEFAULT, values.data()) < 0)
        refuse(group, "the dataset " + group.path_of(name) + " is damaged", last_error());
    return values;
}

Shape shape(const Group& group, std::string_view name) { return shape_of(open_dataset(group, name)); }

std::string type_name(const Group& group, std::string_view name) {
    const Handle id = open_dataset(group, name);
    return name_of_type(Handle(H5Dget_type(id.get()), H5Tclose).get());
}

#define SANDGRAPH_H5_DATASET(T)                                                                          \
    template void write<T>(Group&, std::string_view, std::span<const T>, const Shape&, std::string_view, \
                           Storage);                                                                     \
    template void append<T>(Group&, std::string_view, std::span<const T>);                               \
    template std::vector<T> read<T>(const Group&, std::string_view);
SANDGRAPH_H5_DATASET(double)
SANDGRAPH_H5_DATASET(float)
SANDGRAPH_H5_DATASET(std::int64_t)
SANDGRAPH_H5_DATASET(std::int32_t)
SANDGRAPH_H5_DATASET(std::int16_t)
SANDGRAPH_H5_DATASET(std::uint8_t)
#undef SANDGRAPH_H5_DATASET

}  // namespace sandgraph::io::h5
