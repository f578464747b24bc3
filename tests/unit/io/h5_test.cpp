#include <fmt/format.h>
#include <gtest/gtest.h>

#include <numeric>

#include "base/error.hpp"
#include "io/h5_attribute.hpp"
#include "io/h5_dataset.hpp"
#include "io/h5_file.hpp"
#include "tests/unit/io/scratch.hpp"

#if defined(__SANITIZE_ADDRESS__)
// HDF5 1.10.8 forgets a node when it refuses damaged metadata.
extern "C" const char* __lsan_default_suppressions() { return "leak:libhdf5"; }
#endif

namespace sandgraph::io::h5 {
namespace {

using test::Scratch;

template <class T>
void round_trip(const std::vector<T>& values, Storage storage) {
    const Scratch folder;
    File file = File::create(folder / "a.h5");
    Group root = file.root();
    write(root, "group/values", std::span<const T>(values), {values.size()}, "m", storage);
    file.close();
    const File again = File::open(folder / "a.h5");
    EXPECT_EQ(read<T>(again.root(), "group/values"), values);
}

TEST(Hdf5Dataset, ReadsBackTheSameBitsInEveryStorage) {
    for (const Storage storage : {Storage::contiguous, Storage::packed, Storage::growing}) {
        round_trip<double>({0.1, -0.0, 1e-310, 5e300}, storage);
        round_trip<std::int64_t>({-1, INT64_MAX, INT64_MIN}, storage);
        round_trip<std::uint8_t>({0, 255}, storage);
        round_trip<std::int16_t>({-32768, 7}, storage);
        round_trip<double>({}, storage);
    }
}

TEST(Hdf5Dataset, GrowsByAppendingAndShrinksByTruncating) {
    const Scratch folder;
    File file = File::create(folder / "a.h5");
    Group root = file.root();
    std::vector<double> all(10000);
    std::iota(all.begin(), all.end(), 0.5);
    write(root, "series", std::span<const double>(all.data(), 3), {3}, "", Storage::growing);
    append(root, "series", std::span<const double>(all.data() + 3, all.size() - 3));
    EXPECT_EQ(read<double>(root, "series"), all);
    truncate(root, "series", 7);
    EXPECT_EQ(read<double>(root, "series"), std::vector<double>(all.begin(), all.begin() + 7));
    EXPECT_THROW(truncate(root, "series", 8), InputError);
}

TEST(Hdf5Dataset, RefusesAnotherTypeAndNamesIt) {
    const Scratch folder;
    File file = File::create(folder / "a.h5");
    Group root = file.root();
    const std::vector<std::int64_t> values{1, 2};
    write(root, "n", std::span<const std::int64_t>(values), {2});
    const std::string message = test::message_of<InputError>([&] { read<double>(root, "n"); });
    EXPECT_NE(message.find("/n is int64 (float64 expected)"), std::string::npos) << message;
    EXPECT_THROW(read<double>(root, "missing/deeper"), InputError);
}

TEST(Hdf5Attribute, KeepsNumbersAndTextOfAnyLength) {
    const Scratch folder;
    const std::string scene(100'000, 'x');
    {
        File file = File::create(folder / "a.h5");
        Group root = file.root();
        set_attribute(root, ".", "text", std::string("old"));
        set_attribute(root, ".", "text", scene);
        set_attribute(root, ".", "empty", std::string());
        set_attribute(root, ".", "real", 0.1);
        set_attribute(root, ".", "count", std::int64_t{-3});
        file.close();
    }
    const File file = File::open(folder / "a.h5");
    EXPECT_EQ(get_text(file.root(), ".", "text"), scene);
    EXPECT_EQ(get_text(file.root(), ".", "empty"), "");
    EXPECT_EQ(get_real(file.root(), ".", "real"), 0.1);
    EXPECT_EQ(get_integer(file.root(), ".", "count"), -3);
    EXPECT_EQ(attributes(file.root(), ".").size(), 4u);
    EXPECT_THROW(get_real(file.root(), ".", "text"), InputError);
    EXPECT_THROW(get_text(file.root(), ".", "absent"), InputError);
}

TEST(Hdf5File, TellsMissingForeignAndTruncatedApartInOneLine) {
    const Scratch folder;
    test::overwrite(folder / "foreign.h5", "d_over_B,load_N_per_m\n0,0\n");
    {
        File file = File::create(folder / "cut.h5");
        Group root = file.root();
        const std::vector<double> values(5000, 1.0);
        write(root, "x", std::span<const double>(values), {values.size()}, "", Storage::contiguous);
    }
    std::filesystem::resize_file(folder / "cut.h5", 3000);
    const auto message = [&](const char* name) {
        return test::message_of<InputError>([&] { File::open(folder / name); });
    };
    EXPECT_NE(message("missing.h5").find("no such file"), std::string::npos);
    EXPECT_NE(message("foreign.h5").find("not an HDF5 file"), std::string::npos);
    EXPECT_NE(message("cut.h5").find("truncated"), std::string::npos) << message("cut.h5");
    EXPECT_EQ(message("cut.h5").find('\n'), std::string::npos);
}

TEST(Hdf5File, TakesItsOpenGroupsAlongWithoutAnError) {
    const Scratch folder;
    File file = File::create(folder / "a.h5");
    {
        const Group root = file.root(), below = file.root().create("below");
        file.close();
    }
    EXPECT_EQ(H5Eget_num(H5E_DEFAULT), 0);
}

TEST(Hdf5Error, IsThrownAndNotPrinted) {
    testing::internal::CaptureStderr();
    EXPECT_THROW(File::create("/no/such/folder/a.h5"), std::runtime_error);
    EXPECT_EQ(testing::internal::GetCapturedStderr(), "");
}

TEST(Hdf5Dataset, FlippedByteInPackedDataIsRefused) {
    const Scratch folder;
    std::vector<double> values(100);
    for (std::size_t k = 0; k < values.size(); ++k) values[k] = 1.0 / (1.0 + static_cast<double>(k));
    {
        File file = File::create(folder / "a.h5");
        Group root = file.root();
        write(root, "x", std::span<const double>(values), {values.size()});
        file.close();
    }
    const std::string whole = test::contents(folder / "a.h5");
    int refused = 0;
    for (std::size_t at = 100; at < whole.size(); at += 37) {
        std::string bytes = whole;
        bytes[at] = static_cast<char>(bytes[at] ^ 0x10);
        test::overwrite(folder / "b.h5", bytes);
        try {  // either noticed or harmless (padding), never silently wrong
            EXPECT_EQ(read<double>(File::open(folder / "b.h5").root(), "x"), values) << at;
        } catch (const InputError&) {
            ++refused;
        }
    }
    EXPECT_GT(refused, 10);
}

// HDF5 1.10 frees what it never had when it sorts the names of such a group.
TEST(Hdf5Group, DamagedNamesOfALargeGroupAreRefused) {
    const Scratch folder;
    File file = File::create(folder / "a.h5");
    for (int k = 0; k < 20; ++k) file.root().create(fmt::format("group_{}", k));
    EXPECT_EQ(file.root().names().at(2), "group_10");  // sorted
    file.close();
    std::string bytes = test::contents(folder / "a.h5");
    for (std::size_t at = bytes.find("FHDB"); at != std::string::npos; at = bytes.find("FHDB", at + 1))
        bytes.at(at + 40) = static_cast<char>(bytes.at(at + 40) ^ 0x10);
    test::overwrite(folder / "b.h5", bytes);
    EXPECT_THROW(File::open(folder / "b.h5").root().names(), InputError);
}

TEST(Hdf5Dataset, NumbersOfAnotherFileAreRefused) {
    const Scratch folder;
    const File file = File::create(folder / "a.h5");
    const hsize_t far = hsize_t{1} << 50;
    const Handle space(H5Screate_simple(1, &far, nullptr), H5Sclose),
        list(H5Pcreate(H5P_DATASET_CREATE), H5Pclose);
    H5Pset_external(list.get(), "/dev/zero", 0, H5F_UNLIMITED);
    const Handle made(H5Dcreate2(file.root().id(), "x", H5T_NATIVE_DOUBLE, space.get(), H5P_DEFAULT,
                                 list.get(), H5P_DEFAULT),
                      H5Dclose);
    EXPECT_THROW(read<double>(file.root(), "x"), InputError);
}

}  // namespace
}  // namespace sandgraph::io::h5
