// libFuzzer target of one reader, named by SANDGRAPH_FUZZ_READER at build time (CMake preset `fuzz`).
#include <unistd.h>

#include <cstdint>
#include <cstdlib>
#include <cstring>
#include <fstream>

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

}  // namespace

extern "C" int LLVMFuzzerInitialize(int* argc, char*** argv) {
    // `--sample FILE` writes a valid file for the corpus and ends.
    if (*argc == 3 && std::strcmp((*argv)[1], "--sample") == 0) {
        chosen().write_sample((*argv)[2]);
        std::exit(0);
    }
    return 0;
}

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    std::ofstream(scratch(), std::ios::binary)
        .write(reinterpret_cast<const char*>(data), static_cast<std::streamsize>(size));
    sandgraph::fuzz::read_hostile(chosen(), scratch());
    return 0;
}
