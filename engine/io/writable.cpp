#include "io/writable.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include "base/error.hpp"
#include "io/atomic_file.hpp"

namespace sandgraph::io {
namespace {

namespace fs = std::filesystem;

// Tried out: access() says yes to root even where nothing can be written.
bool can_write_in(const fs::path& folder) {
    const fs::path trial = folder / fmt::format(".sandgraph-{}", getpid());
    std::error_code code;
    const bool made = fs::create_directory(trial, code);
    fs::remove(trial, code);
    return made;
}

}  // namespace

void require_writable(const fs::path& folder) {
    fs::path there = fs::absolute(folder).lexically_normal();
    while (!fs::exists(there) && there.has_relative_path()) there = there.parent_path();
    if (!fs::is_directory(there))
        throw InputError({folder.string(), 0}, "cannot be the folder of the results",
                         there.string() + " is not a folder", "give another folder with -o");
    if (!can_write_in(there))
        throw InputError({folder.string(), 0}, "cannot be the folder of the results",
                         there.string() + " is not writable", "give another folder with -o");
}

void require_writable_file(const fs::path& file) {
    if (file.empty()) return;
    std::error_code unknown;
    const fs::file_status there = fs::status(file, unknown);
    // Renaming the finished file over a device or a pipe would replace it.
    if (there.type() != fs::file_type::not_found && !fs::is_regular_file(there))
        throw InputError({file.string(), 0}, "cannot be written",
                         fs::is_directory(there) ? "it is a folder"
                         : fs::exists(there)     ? "it is no ordinary file"
                                                 : unknown.message(),
                         "give the name of a file");
    const fs::path folder = fs::absolute(io::link_target(file)).lexically_normal().parent_path();
    if (!fs::is_directory(folder))
        throw InputError({file.string(), 0}, "cannot be written", "there is no folder " + folder.string(),
                         "make the folder first, or give another file");
    if (!can_write_in(folder))
        throw InputError({file.string(), 0}, "cannot be written", folder.string() + " is not writable",
                         "give another file");
}

}  // namespace sandgraph::io
