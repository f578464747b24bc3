#include "io/atomic_file.hpp"

#include <fcntl.h>
#include <unistd.h>

#include <cerrno>
#include <fstream>
#include <system_error>

#include "base/contracts.hpp"

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

AtomicFile::AtomicFile(fs::path final_path) : final_(link_target(std::move(final_path))), temporary_(final_) {
    temporary_ += ".tmp";
}

AtomicFile::~AtomicFile() {
    std::error_code ignored;
    if (!committed_) fs::remove(temporary_, ignored);
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

}  // namespace sandgraph::io
