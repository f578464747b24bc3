#include "io/h5_file.hpp"

#include "base/error.hpp"

namespace sandgraph::io::h5 {
namespace {

// With H5F_CLOSE_STRONG a forgotten handle cannot keep a file open (and locked) behind our back. The format
// of HDF5 1.8 and later checksums its metadata and takes attributes beyond 64 kB (scene texts).
Handle file_access() {
    Handle list = own(H5Pcreate(H5P_FILE_ACCESS), H5Pclose, "HDF5", "create a property list");
    H5Pset_fclose_degree(list.get(), H5F_CLOSE_STRONG);
    H5Pset_libver_bounds(list.get(), H5F_LIBVER_V18, H5F_LIBVER_LATEST);
    return list;
}

void require_hdf5(const std::filesystem::path& path) {
    if (!std::filesystem::is_regular_file(path))
        throw InputError({path.string()}, "no such file", "an HDF5 file is expected here", "check the path");
    if (H5Fis_hdf5(path.c_str()) <= 0)
        throw InputError({path.string()}, "not an HDF5 file", "its signature is missing",
                         "give a file written by sandgraph (*.h5)");
}

}  // namespace

File File::create(const std::filesystem::path& path, unsigned user_block) {
    silence();
    const Handle layout = own(H5Pcreate(H5P_FILE_CREATE), H5Pclose, path.string(), "create a property list");
    if (user_block > 0)
        check(H5Pset_userblock(layout.get(), user_block), path.string(), "reserve a user block");
    Handle id = own(H5Fcreate(path.c_str(), H5F_ACC_TRUNC, layout.get(), file_access().get()), H5Fclose,
                    path.string(), "create the file");
    return {std::move(id), path.string()};
}

File File::open(const std::filesystem::path& path, Access access) {
    silence();
    require_hdf5(path);
    const unsigned flags = access == Access::edit ? H5F_ACC_RDWR : H5F_ACC_RDONLY;
    Handle id(H5Fopen(path.c_str(), flags, file_access().get()), H5Fclose);
    if (id.get() < 0)
        throw InputError({path.string()}, "cannot be opened", last_error(),
                         "the file is truncated, damaged or open for writing elsewhere; write it again");
    return {std::move(id), path.string()};
}

Group File::root() const {
    Handle id(H5Gopen2(id_.get(), "/", H5P_DEFAULT), H5Gclose);
    if (id.get() < 0)
        throw InputError({name_}, "damaged", last_error(), "write it again with this version of sandgraph");
    return {std::move(id), name_, "/"};
}

void File::close() {
    check(H5Fflush(id_.get(), H5F_SCOPE_GLOBAL), name_, "write the file");
    id_ = Handle();
}

}  // namespace sandgraph::io::h5
