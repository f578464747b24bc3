#include "io/atomic_file.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <unistd.h>

#include <atomic>
#include <cerrno>
#include <chrono>
#include <csignal>
#include <cstdio>
#include <fstream>
#include <system_error>

#include "base/contracts.hpp"
#include "base/error.hpp"

namespace sandgraph::io {
namespace fs = std::filesystem;
namespace {

[[noreturn]] void fail(int code, const fs::path& path, const char* action) {
    throw std::system_error(code, std::generic_category(), path.string() + ": cannot " + action);
}

fs::path folder_of(const fs::path& path) {
    return path.has_parent_path() ? path.parent_path() : fs::path(".");
}

constexpr int kMostLinks = 40;  // as the kernel follows

// Of this process and this moment: the same file may be written by several programs, and threads, at once.
fs::path own_name(const fs::path& final_path) {
    static std::atomic<int> count{0};
    return fmt::format("{}.{}-{}.tmp", final_path.string(), getpid(), count++);
}

// "FILE.1234-0.tmp" taken to pieces; writer 0: no temporary of ours.
struct Temporary {
    std::string final_name;
    pid_t writer = 0;
};
Temporary parsed(const fs::path& file) {
    const std::string name = file.filename().string();
    if (file.extension() != ".tmp") return {};
    const std::size_t dot = file.stem().string().rfind('.');
    int pid = 0, count = 0, length = 0;
    if (dot == std::string::npos ||
        std::sscanf(name.c_str() + dot, ".%d-%d.tmp%n", &pid, &count, &length) != 2 ||
        dot + static_cast<std::size_t>(length) != name.size())
        return {};
    return {name.substr(0, dot), pid};
}

// No process of this machine has it, and none of another one has touched it for a while.
bool abandoned(const fs::path& file, pid_t writer) {
    if (::kill(writer, 0) == 0 || errno != ESRCH) return false;
    std::error_code gone;
    const auto age = fs::file_time_type::clock::now() - fs::last_write_time(file, gone);
    return !gone && age > std::chrono::minutes(10);
}

// Of `folder` the temporaries that are wanted(file, parsed).
template <class Wanted>
void remove_temporaries(const fs::path& folder, const Wanted& wanted) {
    std::error_code ignored;
    for (const auto& entry : fs::directory_iterator(folder, ignored))
        if (const Temporary t = parsed(entry.path()); t.writer > 0 && wanted(entry.path(), t))
            fs::remove(entry.path(), ignored);
}

void remove_abandoned(const fs::path& final_path) {
    const std::string name = final_path.filename().string();
    remove_temporaries(folder_of(final_path), [&](const fs::path& file, const Temporary& t) {
        return t.final_name == name && abandoned(file, t.writer);
    });
}

// Tried out: access() says yes to root even where nothing can be written.
bool can_write_in(const fs::path& folder) {
    const fs::path trial = folder / fmt::format(".sandgraph-{}", getpid());
    std::error_code code;
    const bool made = fs::create_directory(trial, code);
    fs::remove(trial, code);
    return made;
}

}  // namespace

fs::path link_target(fs::path path) {
    std::error_code none;
    for (int k = 0; k < kMostLinks && fs::is_symlink(fs::symlink_status(path, none)); ++k)
        path = path.parent_path() / fs::read_symlink(path);
    return path;
}

void sync_to_disk(const fs::path& path) {
    const int fd = ::open(path.c_str(), O_RDONLY | O_CLOEXEC);
    if (fd < 0) fail(errno, path, "open");
    const int status = ::fsync(fd), code = errno;
    ::close(fd);
    // Some file systems cannot sync a folder (EINVAL); the rename is then as durable as they allow.
    if (status != 0 && code != EINVAL) fail(code, path, "flush");
}

AtomicFile::AtomicFile(fs::path final_path)
    : final_(link_target(std::move(final_path))), temporary_(own_name(final_)) {
    remove_abandoned(final_);
}

AtomicFile::~AtomicFile() {
    std::error_code ignored;
    if (!committed_) fs::remove(temporary_, ignored);
}

void remove_temporaries(const fs::path& folder) {
    remove_temporaries(folder, [](auto&&...) { return true; });
}

void AtomicFile::commit() {
    SG_EXPECT(!committed_);
    sync_to_disk(temporary_);
    fs::rename(temporary_, final_);
    committed_ = true;
    sync_to_disk(folder_of(final_));
}

void AtomicFile::commit_keeping(const fs::path& previous) {
    SG_EXPECT(!committed_ && previous != final_);
    if (fs::exists(final_)) {
        fs::remove(previous);
        // A hard link, so that the final name never disappears; a copy where links do not exist.
        std::error_code code;
        fs::create_hard_link(final_, previous, code);
        if (code) fs::copy_file(final_, previous);
    }
    commit();
}

void write_text(const fs::path& path, std::string_view text) {
    AtomicFile file(path);
    {
        std::ofstream out(file.temporary(), std::ios::binary);
        out.write(text.data(), static_cast<std::streamsize>(text.size()));
        out.flush();
        if (!out) fail(EIO, file.temporary(), "write");
    }
    file.commit();
}

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
