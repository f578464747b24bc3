#include "io/h5_file.hpp"

#include <bit>
#include <fstream>
#include <stdexcept>
#include <string_view>

#include "base/contracts.hpp"
#include "base/error.hpp"

namespace sandgraph::io::h5 {
namespace {

// With H5F_CLOSE_STRONG a forgotten handle cannot keep a file open (and locked) behind our back. The format
// of HDF5 1.10 and later checksums all of its metadata and takes attributes beyond 64 kB (scene texts).
Handle file_access(bool locked) {
    Handle list = own(H5Pcreate(H5P_FILE_ACCESS), H5Pclose, "HDF5", "create a property list");
    H5Pset_fclose_degree(list.get(), H5F_CLOSE_STRONG);
    H5Pset_libver_bounds(list.get(), H5F_LIBVER_V110, H5F_LIBVER_LATEST);
    H5Pset_file_locking(list.get(), locked, true);
    return list;
}

// What HDF5 says on a file system without locks: ENOLCK, ENOSYS, EOPNOTSUPP.
bool locks_missing(const std::string& error) {
    const auto says = [&](const char* words) { return error.find(words) != std::string::npos; };
    return says("unable to lock file") &&
           (says("No locks available") || says("not implemented") || says("not supported"));
}

struct Opened {
    Handle id;
    std::string error;  // where there is no id
};

// Locked, so that two processes do not write one file; where there are no locks, without.
template <class Open>
Opened open_file(Open open) {
    std::string error;
    for (const bool locked : {true, false}) {
        const Handle access = file_access(locked);
        Handle id(open(access.get()), H5Fclose);
        if (id.get() >= 0) return {std::move(id), ""};
        error = last_error();  // before another call of the library clears it
        if (!locks_missing(error)) break;
    }
    return {Handle(), error};
}

// Version of the superblock, which stands behind an 8-byte signature at the start or after a user block.
int superblock_version(const std::filesystem::path& path) {
    constexpr std::string_view signature = "\x89HDF\r\n\x1a\n";
    std::ifstream in(path, std::ios::binary);
    char head[9] = {};
    for (std::streamoff at = 0; in.seekg(at) && in.read(head, sizeof head); at = at == 0 ? 512 : 2 * at)
        if (std::string_view(head, 8) == signature) return static_cast<unsigned char>(head[8]);
    return -1;
}

// Metadata without checksums makes HDF5 1.10 crash or ask for terabytes when it is damaged (found by
// fuzzing).
constexpr int first_checksummed = 2;

void require_hdf5(const std::filesystem::path& path) {
    std::error_code none;
    if (std::filesystem::is_directory(path, none))
        throw InputError({path.string()}, "a folder", "an HDF5 file is expected here", "name a file in it");
    if (!std::filesystem::is_regular_file(path, none))
        throw InputError({path.string()}, "no such file", "an HDF5 file is expected here", "check the path");
    if (superblock_version(path) < 0)
        throw InputError({path.string()}, "not an HDF5 file", "its signature is missing",
                         "give a file written by sandgraph (*.h5)");
    if (superblock_version(path) < first_checksummed)
        throw InputError({path.string()}, "an HDF5 file of the old format",
                         "its metadata carries no checksums",
                         "write it with libver=\"v110\" (h5py) or later");
}

}  // namespace

File File::create(const std::filesystem::path& path, unsigned user_block) {
    SG_EXPECT(user_block == 0 || (user_block >= 512 && std::has_single_bit(user_block)));
    silence();
    const Handle layout = own(H5Pcreate(H5P_FILE_CREATE), H5Pclose, path.string(), "create a property list");
    if (user_block > 0)
        check(H5Pset_userblock(layout.get(), user_block), path.string(), "reserve a user block");
    Opened file =
        open_file([&](hid_t access) { return H5Fcreate(path.c_str(), H5F_ACC_TRUNC, layout.get(), access); });
    if (file.id.get() < 0)
        throw std::runtime_error(path.string() + ": cannot create the file (HDF5: " + file.error + ")");
    return {std::move(file.id), path.string()};
}

File File::open(const std::filesystem::path& path, Access access) {
    silence();
    require_hdf5(path);
    const unsigned flags = access == Access::edit ? H5F_ACC_RDWR : H5F_ACC_RDONLY;
    Opened file = open_file([&](hid_t rights) { return H5Fopen(path.c_str(), flags, rights); });
    if (file.id.get() < 0)
        throw InputError({path.string()}, "cannot be opened", file.error,
                         "the file is truncated, damaged or open for writing elsewhere; write it again");
    return {std::move(file.id), path.string()};
}

Group File::root() const {
    Handle id(H5Gopen2(id_.get(), "/", H5P_DEFAULT), H5Gclose);
    if (id.get() < 0)
        throw InputError({name_}, "damaged", last_error(), "write it again with this version of sandgraph");
    return {std::move(id), name_, "/"};
}

void File::close() {
    SG_EXPECT(id_.get() >= 0);  // once
    check(H5Fflush(id_.get(), H5F_SCOPE_GLOBAL), name_, "write the file");
    id_ = Handle();
}

}  // namespace sandgraph::io::h5
