#include "io/h5_group.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "base/contracts.hpp"
#include "base/error.hpp"

namespace sandgraph::io::h5 {
namespace {

herr_t collect(hid_t, const char* name, const H5L_info_t*, void* names) {
    static_cast<std::vector<std::string>*>(names)->emplace_back(name);
    return 0;
}

Handle intermediate_groups() {
    Handle list = own(H5Pcreate(H5P_LINK_CREATE), H5Pclose, "HDF5", "create a property list");
    H5Pset_create_intermediate_group(list.get(), 1);
    return list;
}

}  // namespace

Group::Group(Handle id, std::string file, std::string path)
    : id_(std::move(id)), file_(std::move(file)), path_(std::move(path)) {}

std::string Group::path_of(std::string_view name) const {
    return path_ == "/" ? fmt::format("/{}", name) : fmt::format("{}/{}", path_, name);
}

Group Group::create(std::string_view name) {
    SG_EXPECT(!name.empty() && id_.get() >= 0);
    const std::string text(name);
    Handle id =
        own(H5Gcreate2(id_.get(), text.c_str(), intermediate_groups().get(), H5P_DEFAULT, H5P_DEFAULT),
            H5Gclose, file_, "create the group " + path_of(name));
    return {std::move(id), file_, path_of(name)};
}

Group Group::open(std::string_view name) const {
    const std::string text(name);
    Handle id(has(name) ? H5Gopen2(id_.get(), text.c_str(), H5P_DEFAULT) : H5I_INVALID_HID, H5Gclose);
    if (id.get() < 0) refuse(*this, "the group " + path_of(name) + " is missing", last_error());
    return {std::move(id), file_, path_of(name)};
}

bool Group::has(std::string_view name) const {
    // H5Lexists asks that every group on the way exists, so they are asked one by one.
    for (std::size_t end = name.find('/', 1);; end = name.find('/', end + 1)) {
        const std::string part(name.substr(0, end));
        if (H5Lexists(id_.get(), part.c_str(), H5P_DEFAULT) <= 0) return false;
        if (end == std::string_view::npos) return true;
    }
}

void Group::remove(std::string_view name) {
    check(H5Ldelete(id_.get(), std::string(name).c_str(), H5P_DEFAULT), file_, "remove " + path_of(name));
}

std::vector<std::string> Group::names() const {
    std::vector<std::string> result;
    // Sorted here: HDF5 1.10 crashes when it sorts a large group whose heap is damaged (found by fuzzing).
    if (H5Literate(id_.get(), H5_INDEX_NAME, H5_ITER_NATIVE, nullptr, collect, &result) < 0)
        refuse(*this, "the group " + path_ + " is damaged", last_error());
    std::ranges::sort(result);
    return result;
}

Kind Group::kind(std::string_view name) const {
    const Handle object(H5Oopen(id_.get(), std::string(name).c_str(), H5P_DEFAULT), H5Oclose);
    if (object.get() < 0) refuse(*this, path_of(name) + " is damaged", last_error());
    const H5I_type_t type = H5Iget_type(object.get());
    return type == H5I_GROUP ? Kind::group : type == H5I_DATASET ? Kind::dataset : Kind::other;
}

void refuse(const Group& group, const std::string& what, const std::string& why) {
    throw InputError({group.file()}, what, why, "write the file again with this version of sandgraph");
}

}  // namespace sandgraph::io::h5
