#include "fuzz/h5_mutator.hpp"

#include <algorithm>
#include <array>
#include <cstring>
#include <limits>
#include <random>
#include <string>
#include <string_view>

#include "io/h5_handle.hpp"

// Of the library, though not of its public headers.
extern "C" std::uint32_t H5_checksum_metadata(const void* data, std::size_t size, std::uint32_t start);

namespace sandgraph::fuzz {
namespace {

using io::h5::Handle;
using Bytes = std::vector<std::uint8_t>;
using Random = std::minstd_rand;

constexpr double infinite = std::numeric_limits<double>::infinity();
constexpr std::array odd_numbers = {
    0.0,   -1.0,         1.0,      2.0,       255.0,
    256.0, 4096.0,       -0.5,     1e-12,     1e300,
    -1e18, 4294967296.0, infinite, -infinite, std::numeric_limits<double>::quiet_NaN()};
constexpr std::array<std::int64_t, 12> odd_integers = {0,
                                                       -1,
                                                       1,
                                                       2,
                                                       3,
                                                       7,
                                                       8,
                                                       255,
                                                       256,
                                                       1LL << 31,
                                                       std::numeric_limits<std::int64_t>::max(),
                                                       std::numeric_limits<std::int64_t>::min()};
constexpr std::array<hsize_t, 9> odd_extents = {0, 1, 2, 3, 4, 5, 4097, 1ULL << 32, 1ULL << 50};
constexpr std::array<const char*, 7> odd_texts = {"",          "\n",       "run",       "history",
                                                  "surrogate", "\xff\xfe", "a\nb {} %s"};

std::size_t below(Random& random, std::size_t n) { return random() % n; }
template <class List>
auto pick(const List& list, Random& random) {
    return list[below(random, list.size())];
}

struct Object {
    std::string path;
    H5O_type_t type;
};

herr_t collect(hid_t, const char* name, const H5O_info_t* info, void* objects) {
    static_cast<std::vector<Object>*>(objects)->push_back({name, info->type});
    return 0;
}

// An attribute of the name with a random value of a random type, in place of the one that stood there.
bool write_attribute(hid_t object, const std::string& name, Random& random) {
    const std::string text = pick(odd_texts, random);
    const Handle string(H5Tcopy(H5T_C_S1), H5Tclose);
    H5Tset_size(string.get(), std::max<std::size_t>(1, text.size()));
    const double numbers[2] = {pick(odd_numbers, random), 0};
    const std::int64_t integer = pick(odd_integers, random);
    const hsize_t two = 2;
    const std::size_t kind = below(random, 8);
    const Handle space(kind == 0 ? H5Screate_simple(1, &two, nullptr) : H5Screate(H5S_SCALAR), H5Sclose);
    const hid_t type = kind < 3 ? H5T_NATIVE_DOUBLE : kind < 6 ? H5T_NATIVE_INT64 : string.get();
    const void* value = kind < 3   ? static_cast<const void*>(numbers)
                        : kind < 6 ? static_cast<const void*>(&integer)
                                   : text.c_str();
    const Handle made(H5Acreate2(object, name.c_str(), type, space.get(), H5P_DEFAULT, H5P_DEFAULT),
                      H5Aclose);
    return made.get() >= 0 && H5Awrite(made.get(), type, value) >= 0;
}

bool change_attribute(hid_t file, const Object& o, Random& random) {
    const Handle object(H5Oopen(file, o.path.c_str(), H5P_DEFAULT), H5Oclose);
    const int count = H5Aget_num_attrs(object.get());
    if (count <= 0) return false;
    char name[256] = {};
    if (H5Aget_name_by_idx(object.get(), ".", H5_INDEX_NAME, H5_ITER_INC, below(random, count), name,
                           sizeof name, H5P_DEFAULT) < 0)
        return false;
    if (H5Adelete(object.get(), name) < 0) return false;
    return below(random, 8) == 0 || write_attribute(object.get(), name, random);
}

bool change_numbers(hid_t file, const Object& o, Random& random) {
    const Handle data(H5Dopen2(file, o.path.c_str(), H5P_DEFAULT), H5Dclose),
        space(H5Dget_space(data.get()), H5Sclose);
    const hssize_t count = H5Sget_simple_extent_npoints(space.get());
    if (count <= 0 || count > 100000) return false;
    std::vector<double> values(static_cast<std::size_t>(count));
    if (H5Dread(data.get(), H5T_NATIVE_DOUBLE, H5S_ALL, H5S_ALL, H5P_DEFAULT, values.data()) < 0)
        return false;
    double& one = values[below(random, values.size())];
    one = below(random, 3) == 0 ? -one : pick(odd_numbers, random);
    return H5Dwrite(data.get(), H5T_NATIVE_DOUBLE, H5S_ALL, H5S_ALL, H5P_DEFAULT, values.data()) >= 0;
}

bool change_extent(hid_t file, const Object& o, Random& random) {
    const Handle data(H5Dopen2(file, o.path.c_str(), H5P_DEFAULT), H5Dclose),
        space(H5Dget_space(data.get()), H5Sclose);
    std::array<hsize_t, H5S_MAX_RANK> extent = {};
    const int axes = H5Sget_simple_extent_dims(space.get(), extent.data(), nullptr);
    if (axes <= 0) return false;
    // To shrink an axis, HDF5 looks for each chunk that goes, along all axes: hours of a large one.
    double most = 1;
    for (int k = 0; k < axes; ++k) most *= std::max(1.0, static_cast<double>(extent[k]));
    if (most > 100000) return false;
    extent[below(random, axes)] = pick(odd_extents, random);
    return H5Dset_extent(data.get(), extent.data()) >= 0;
}

// Another dataset of the name: of any number type, with up to three axes, on disk, in chunks or in another
// file.
bool replace_dataset(hid_t file, const Object& o, Random& random) {
    const std::array types = {H5T_NATIVE_DOUBLE, H5T_NATIVE_FLOAT, H5T_NATIVE_INT64,
                              H5T_NATIVE_UINT8,  H5T_NATIVE_INT32, H5T_C_S1};
    std::array<hsize_t, 3> extent = {};
    for (hsize_t& n : extent) n = pick(odd_extents, random);
    const std::array<hsize_t, 3> chunk = {16, 1, 1};
    const int axes = static_cast<int>(below(random, 4));
    const Handle space(axes == 0 ? H5Screate(below(random, 2) ? H5S_SCALAR : H5S_NULL)
                                 : H5Screate_simple(axes, extent.data(), nullptr),
                       H5Sclose),
        list(H5Pcreate(H5P_DATASET_CREATE), H5Pclose);
    const std::size_t storage = below(random, 4);
    if (storage == 0) H5Pset_external(list.get(), "/dev/zero", 0, H5F_UNLIMITED);
    if (storage == 1 && axes > 0) H5Pset_chunk(list.get(), axes, chunk.data());
    if (H5Ldelete(file, o.path.c_str(), H5P_DEFAULT) < 0) return false;
    return Handle(H5Dcreate2(file, o.path.c_str(), pick(types, random), space.get(), H5P_DEFAULT, list.get(),
                             H5P_DEFAULT),
                  H5Dclose)
               .get() >= 0;
}

// Another object, or none, under its name.
bool change_link(hid_t file, const Object& o, const std::vector<Object>& objects, Random& random) {
    const std::string target = "/" + pick(objects, random).path, &name = o.path;
    const Handle kept(H5Oopen(file, target.c_str(), H5P_DEFAULT), H5Oclose);
    if (H5Ldelete(file, name.c_str(), H5P_DEFAULT) < 0) return false;
    switch (below(random, 5)) {
        case 0:
            return true;
        case 1:
            return H5Lcreate_soft(target.c_str(), file, name.c_str(), H5P_DEFAULT, H5P_DEFAULT) >= 0;
        case 2:
            return H5Lcreate_external("/dev/zero", "/", file, name.c_str(), H5P_DEFAULT, H5P_DEFAULT) >= 0;
        case 3:
            return Handle(H5Gcreate2(file, name.c_str(), H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT), H5Gclose)
                       .get() >= 0;
        default:
            return H5Olink(kept.get(), file, name.c_str(), H5P_DEFAULT, H5P_DEFAULT) >= 0;
    }
}

// False: not every object takes every change. Only the first change takes links away: HDF5 1.10 crashes when
// it deletes what was changed just before.
bool change(hid_t file, bool first, Random& random) {
    std::vector<Object> objects;
    if (H5Ovisit(file, H5_INDEX_NAME, H5_ITER_NATIVE, collect, &objects) < 0 || objects.empty()) return false;
    const Object o = pick(objects, random);
    const std::size_t kind = below(random, 8);
    if (kind < 3) return change_attribute(file, o, random);
    if (o.path == "." || (kind < 5 && !first)) return false;
    if (kind == 3) return change_link(file, o, objects, random);
    if (o.type != H5O_TYPE_DATASET) return false;
    return kind == 4   ? replace_dataset(file, o, random)
           : kind == 5 ? change_extent(file, o, random)
                       : change_numbers(file, o, random);
}

Handle open_image(Bytes& bytes) {
    const Handle list(H5Pcreate(H5P_FILE_ACCESS), H5Pclose);
    H5Pset_fapl_core(list.get(), 4096, false);
    H5Pset_file_image(list.get(), bytes.data(), bytes.size());
    H5Pset_fclose_degree(list.get(), H5F_CLOSE_STRONG);
    H5Pset_libver_bounds(list.get(), H5F_LIBVER_V110, H5F_LIBVER_LATEST);
    return Handle(H5Fopen("image", H5F_ACC_RDWR, list.get()), H5Fclose);
}

// Bytes in front of the HDF5 file proper, which HDF5 does not hand out with the image.
std::size_t user_block(const Bytes& bytes) {
    constexpr std::string_view signature = "\x89HDF\r\n\x1a\n";
    return bytes.size() > 8 && std::memcmp(bytes.data(), signature.data(), 8) == 0 ? 0 : 512;
}

// The image of a file that is open for writing says so in its superblock; then nobody else opens it.
void mark_closed(std::uint8_t* superblock) {
    constexpr std::size_t flags = 11, checked = 44;
    superblock[flags] = 0;
    const std::uint32_t checksum = H5_checksum_metadata(superblock, checked, 0);
    std::memcpy(superblock + checked, &checksum, sizeof checksum);
}

}  // namespace

bool mutate_h5(Bytes& bytes, unsigned seed) {
    io::h5::silence();
    Random random(seed % 2147483646 + 1);
    const Handle file = open_image(bytes);
    if (file.get() < 0) return false;
    const std::size_t changes = 1 + below(random, 4);
    for (std::size_t k = 0; k < changes; ++k) change(file.get(), k == 0, random);
    if (H5Fflush(file.get(), H5F_SCOPE_GLOBAL) < 0) return false;
    const std::size_t front = user_block(bytes);
    const ssize_t size = H5Fget_file_image(file.get(), nullptr, 0);
    if (size < 48) return false;
    bytes.resize(front + static_cast<std::size_t>(size));
    if (H5Fget_file_image(file.get(), bytes.data() + front, static_cast<std::size_t>(size)) < 0) return false;
    mark_closed(bytes.data() + front);
    return true;
}

}  // namespace sandgraph::fuzz
