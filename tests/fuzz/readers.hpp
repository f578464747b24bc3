#pragma once
#include <filesystem>
#include <ostream>
#include <span>

namespace sandgraph::fuzz {

// A reader of files that anybody may hand to the program. `read` returns or throws InputError; anything else
// (another exception, a crash, a hang, a huge allocation) is a finding.
struct Reader {
    const char* name;       // folder of its findings and of its corpus
    const char* extension;  // of the files it reads
    void (*read)(const std::filesystem::path& file);
    void (*write_sample)(const std::filesystem::path& file);  // a whole, valid file to start from
};

std::span<const Reader> readers();

// How GoogleTest names a reader; its bytes hold addresses, other ones in every process.
inline void PrintTo(const Reader& reader, std::ostream* out) { *out << reader.name; }

// Reads the file; InputError is an answer, and its text must hold exactly one line.
void read_hostile(const Reader& reader, const std::filesystem::path& file);

}  // namespace sandgraph::fuzz
