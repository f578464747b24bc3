#include "io/folder_lock.hpp"

#include <fcntl.h>
#include <fmt/chrono.h>
#include <fmt/format.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <ctime>

#include "base/console.hpp"
#include "base/error.hpp"
#include "io/atomic_file.hpp"

namespace sandgraph::io {
namespace fs = std::filesystem;
namespace {

constexpr const char* kName = ".sandgraph.lock";

std::string owner_text() {
    std::array<char, 256> host{};
    gethostname(host.data(), host.size() - 1);
    return fmt::format("process {} on {} since {:%F %T}", getpid(), host.data(),
                       fmt::localtime(std::time(nullptr)));
}

std::string read_owner(int fd) {
    std::array<char, 400> text{};
    const ssize_t length = ::pread(fd, text.data(), text.size(), 0);
    return length > 0 ? std::string(text.data(), static_cast<std::size_t>(length)) : "another process";
}

void write_owner(int fd) {
    const std::string text = owner_text();
    // Who cannot be named is locked out all the same.
    [[maybe_unused]] const bool named =
        ::ftruncate(fd, 0) == 0 &&
        ::pwrite(fd, text.data(), text.size(), 0) == static_cast<ssize_t>(text.size());
}

// Between opening and locking the former owner may have removed the file: its lock would guard nothing.
bool is_still(int fd, const fs::path& file) {
    struct stat held {
    }, there{};
    return ::fstat(fd, &held) == 0 && ::stat(file.c_str(), &there) == 0 && held.st_ino == there.st_ino &&
           held.st_dev == there.st_dev;
}

fs::path first_missing(const fs::path& folder) {
    fs::path missing, there = fs::absolute(folder).lexically_normal();
    if (!there.has_filename()) there = there.parent_path();
    std::error_code unknown;
    for (; !fs::exists(there, unknown) && there.has_relative_path(); there = there.parent_path())
        missing = there;
    return missing;
}

// The locked file, -1 where the file system has no locks.
int lock(const fs::path& folder) {
    const fs::path file = folder / kName;
    for (;;) {
        const int fd = ::open(file.c_str(), O_RDWR | O_CREAT | O_CLOEXEC, 0666);
        if (fd < 0) throw std::system_error(errno, std::generic_category(), file.string() + ": cannot open");
        if (::flock(fd, LOCK_EX | LOCK_NB) != 0) {
            const bool taken = errno == EWOULDBLOCK;
            const std::string owner = taken ? read_owner(fd) : "";
            ::close(fd);
            if (!taken) return -1;
            throw InputError({folder.string(), 0}, "another sandgraph works in this folder", owner,
                             "wait for its end, or give another folder with -o");
        }
        if (is_still(fd, file)) return fd;
        ::close(fd);
    }
}

}  // namespace

FolderLock::FolderLock(fs::path folder) : folder_(std::move(folder)) {
    require_writable(folder_);
    made_ = first_missing(folder_);
    fs::create_directories(folder_);
    fd_ = lock(folder_);
    if (fd_ >= 0) {
        write_owner(fd_);
        return;
    }
    std::error_code ignored;
    fs::remove(folder_ / kName, ignored);
    notice(fmt::format("{}: this file system has no locks, so keep other runs out of this folder",
                       folder_.string()));
}

FolderLock::~FolderLock() {
    std::error_code ignored;
    if (fd_ >= 0) {
        fs::remove(folder_ / kName, ignored);  // while it is held: nobody else's is taken away
        ::close(fd_);
    }
    if (made_.empty()) return;
    // Only folders that are empty go.
    fs::path last = fs::absolute(folder_).lexically_normal();
    if (!last.has_filename()) last = last.parent_path();
    while (fs::remove(last, ignored) && last != made_) last = last.parent_path();
}

}  // namespace sandgraph::io
