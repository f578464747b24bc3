// libFuzzer target of one reader, named by SANDGRAPH_FUZZ_READER at build time (CMake preset `fuzz`).
#include <hdf5.h>
#include <unistd.h>

#include <algorithm>
#include <cstdint>
#include <cstdlib>
#include <cstring>
#include <fstream>
#include <iterator>
#include <vector>

#include "fuzz/h5_mutator.hpp"
#include "fuzz/readers.hpp"

namespace {

namespace fs = std::filesystem;

const sandgraph::fuzz::Reader& chosen() {
    for (const auto& reader : sandgraph::fuzz::readers())
        if (std::strcmp(reader.name, SANDGRAPH_FUZZ_READER) == 0) return reader;
    std::abort();
}

// A file in memory: the readers take paths.
const fs::path& scratch() {
    static const fs::path file = "/dev/shm/sandgraph-fuzz-" + std::to_string(getpid()) + chosen().extension;
    return file;
}

const std::vector<std::uint8_t>& sample() {
    static const std::vector<std::uint8_t> bytes = [] {
        chosen().write_sample(scratch());
        std::ifstream in(scratch(), std::ios::binary);
        return std::vector<std::uint8_t>(std::istreambuf_iterator<char>(in), {});
    }();
    return bytes;
}

}  // namespace

extern "C" std::size_t LLVMFuzzerMutate(std::uint8_t* data, std::size_t size, std::size_t most);

extern "C" int LLVMFuzzerInitialize(int* argc, char*** argv) {
    // `--sample FILE` writes a valid file for the corpus and ends.
    if (*argc == 3 && std::strcmp((*argv)[1], "--sample") == 0) {
        chosen().write_sample((*argv)[2]);
        std::exit(0);
    }
    // HDF5 keeps its half megabyte of tables a file for the next one: twice as many executions. Not without
    // end: a block of each size that damaged files ask for adds up to gigabytes.
    constexpr int kept = 32 << 20;
    H5set_free_list_limits(kept, kept, kept, kept, kept, kept);
    return 0;
}

// Every other change of an HDF5 file starts from the sample and keeps all checksums.
extern "C" std::size_t LLVMFuzzerCustomMutator(std::uint8_t* data, std::size_t size, std::size_t most,
                                               unsigned seed) {
    if (chosen().extension == std::string_view(".h5") && seed % 2 == 0) {
        std::vector<std::uint8_t> bytes = sample();
        if (sandgraph::fuzz::mutate_h5(bytes, seed / 2) && bytes.size() <= most) {
            std::ranges::copy(bytes, data);
            return bytes.size();
        }
    }
    return LLVMFuzzerMutate(data, size, most);
}

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    std::ofstream(scratch(), std::ios::binary)
        .write(reinterpret_cast<const char*>(data), static_cast<std::streamsize>(size));
    sandgraph::fuzz::read_hostile(chosen(), scratch());
    return 0;
}
