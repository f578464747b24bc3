#include "io/h5_attribute.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "base/contracts.hpp"

namespace sandgraph::io::h5 {
namespace {

// Fixed-length UTF-8; HDF5 knows no string of length zero.
Handle text_type(std::size_t length) {
    Handle type = own(H5Tcopy(H5T_C_S1), H5Tclose, "HDF5", "copy a type");
    H5Tset_size(type.get(), std::max<std::size_t>(length, 1));
    H5Tset_strpad(type.get(), H5T_STR_NULLPAD);
    H5Tset_cset(type.get(), H5T_CSET_UTF8);
    return type;
}

Handle type_of(const Value& value) {
    if (std::holds_alternative<double>(value)) return Handle(H5Tcopy(H5T_NATIVE_DOUBLE), H5Tclose);
    if (std::holds_alternative<std::int64_t>(value)) return Handle(H5Tcopy(H5T_NATIVE_INT64), H5Tclose);
    return text_type(std::get<std::string>(value).size());
}

const void* bytes_of(const Value& value) {
    if (const auto* real = std::get_if<double>(&value)) return real;
    if (const auto* integer = std::get_if<std::int64_t>(&value)) return integer;
    return std::get<std::string>(value).c_str();  // at least the final zero
}

Handle open_attribute(const Group& group, std::string_view object, std::string_view name) {
    Handle id(H5Aopen_by_name(group.id(), std::string(object).c_str(), std::string(name).c_str(), H5P_DEFAULT,
                              H5P_DEFAULT),
              H5Aclose);
    if (id.get() < 0)
        refuse(group, fmt::format("attribute '{}' of {} is missing", name, group.path_of(object)),
               last_error());
    return id;
}

std::string read_text(const Handle& attribute, const Handle& type) {
    if (H5Tis_variable_str(type.get()) > 0) {
        char* raw = nullptr;
        if (H5Aread(attribute.get(), type.get(), &raw) < 0 || !raw) return {};
        std::string text(raw);
        H5free_memory(raw);
        return text;
    }
    std::string text(H5Tget_size(type.get()), '\0');
    if (H5Aread(attribute.get(), text_type(text.size()).get(), text.data()) < 0) return {};
    return text.substr(0, text.find_last_not_of('\0') + 1);
}

template <class T>
T read_number(const Handle& attribute, hid_t memory_type) {
    T value{};
    H5Aread(attribute.get(), memory_type, &value);
    return value;
}

bool is_scalar(const Handle& attribute) {
    const Handle space(H5Aget_space(attribute.get()), H5Sclose);
    return H5Sget_simple_extent_npoints(space.get()) == 1;
}

Value read_value(const Group& group, std::string_view object, std::string_view name) {
    const Handle attribute = open_attribute(group, object, name);
    const Handle type(H5Aget_type(attribute.get()), H5Tclose);
    const std::string what = fmt::format("attribute '{}' of {}", name, group.path_of(object));
    if (!is_scalar(attribute)) refuse(group, what + " is not one value", "it is an array");
    switch (H5Tget_class(type.get())) {
        case H5T_STRING:
            return read_text(attribute, type);
        case H5T_FLOAT:
            return read_number<double>(attribute, H5T_NATIVE_DOUBLE);
        case H5T_INTEGER:
            return read_number<std::int64_t>(attribute, H5T_NATIVE_INT64);
        default:
            refuse(group, what + " has an unknown type", "neither number nor text");
    }
}

template <class T>
T read_as(const Group& group, std::string_view object, std::string_view name, const char* kind) {
    const Value value = read_value(group, object, name);
    if (const T* held = std::get_if<T>(&value)) return *held;
    refuse(group, fmt::format("attribute '{}' of {} is not {}", name, group.path_of(object), kind),
           "another type was found");
}

herr_t collect(hid_t, const char* name, const H5A_info_t*, void* names) {
    static_cast<std::vector<std::string>*>(names)->emplace_back(name);
    return 0;
}

}  // namespace

void set_attribute(Group& group, std::string_view object, std::string_view name, const Value& value) {
    SG_EXPECT(!object.empty() && !name.empty());
    const std::string target(object), label(name);
    if (has_attribute(group, object, name))
        H5Adelete_by_name(group.id(), target.c_str(), label.c_str(), H5P_DEFAULT);
    const Handle type = type_of(value), space(H5Screate(H5S_SCALAR), H5Sclose);
    const Handle id = own(H5Acreate_by_name(group.id(), target.c_str(), label.c_str(), type.get(),
                                            space.get(), H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT),
                          H5Aclose, group.file(), "write the attribute " + label);
    check(H5Awrite(id.get(), type.get(), bytes_of(value)), group.file(), "write the attribute " + label);
}

double get_real(const Group& group, std::string_view object, std::string_view name) {
    return read_as<double>(group, object, name, "a real number");
}

std::int64_t get_integer(const Group& group, std::string_view object, std::string_view name) {
    return read_as<std::int64_t>(group, object, name, "an integer");
}

std::string get_text(const Group& group, std::string_view object, std::string_view name) {
    return read_as<std::string>(group, object, name, "text");
}

bool has_attribute(const Group& group, std::string_view object, std::string_view name) {
    return H5Aexists_by_name(group.id(), std::string(object).c_str(), std::string(name).c_str(),
                             H5P_DEFAULT) > 0;
}

std::vector<Attribute> attributes(const Group& group, std::string_view object) {
    std::vector<std::string> names;
    // As in Group::names(): HDF5 must not sort.
    if (H5Aiterate_by_name(group.id(), std::string(object).c_str(), H5_INDEX_NAME, H5_ITER_NATIVE, nullptr,
                           collect, &names, H5P_DEFAULT) < 0)
        refuse(group, "the attributes of " + group.path_of(object) + " are damaged", last_error());
    std::ranges::sort(names);
    std::vector<Attribute> result;
    for (const std::string& name : names) result.push_back({name, read_value(group, object, name)});
    return result;
}

}  // namespace sandgraph::io::h5
