#include <gtest/gtest.h>

#include "fuzz/readers.hpp"
#include "support/paths.hpp"

namespace sandgraph::fuzz {
namespace {

namespace fs = std::filesystem;

class HostileFiles : public testing::TestWithParam<Reader> {};

// A reader may leave a mark in what it reads (a new seal), so it gets a copy.
void read_copy(const Reader& reader, const fs::path& original) {
    const fs::path copy =
        fs::path(testing::TempDir()) / ("finding_" + std::string(reader.name) + reader.extension);
    fs::copy_file(original, copy, fs::copy_options::overwrite_existing);
    EXPECT_NO_THROW(read_hostile(reader, copy)) << original;
    fs::remove(copy);
}

TEST_P(HostileFiles, WhatFuzzingFoundIsReadOrRefused) {
    const fs::path folder = fs::path(sandgraph::test::source_file("/tests/fuzz/findings")) / GetParam().name;
    if (!fs::exists(folder)) return;  // nothing found yet
    for (const auto& entry : fs::directory_iterator(folder)) read_copy(GetParam(), entry.path());
}

TEST_P(HostileFiles, ASampleIsReadAndItsTruncationsAreReadOrRefused) {
    const Reader& reader = GetParam();
    const fs::path sample =
        fs::path(testing::TempDir()) / ("sample_" + std::string(reader.name) + reader.extension);
    reader.write_sample(sample);
    ASSERT_NO_THROW(reader.read(sample));
    for (std::uintmax_t size = fs::file_size(sample); size > 0; size = size * 7 / 8) {
        fs::resize_file(sample, size);
        EXPECT_NO_THROW(read_hostile(reader, sample)) << size;
    }
    fs::remove(sample);
}

std::string name_of(const testing::TestParamInfo<Reader>& info) { return info.param.name; }

INSTANTIATE_TEST_SUITE_P(Readers, HostileFiles, testing::ValuesIn(readers().begin(), readers().end()),
                         name_of);

}  // namespace
}  // namespace sandgraph::fuzz
