#pragma once
#include <filesystem>
#include <string_view>

namespace sandgraph::io {

// A file that appears whole or not at all: write to `temporary()`, then `commit()` flushes it to the disk and
// renames it over the final name; a symbolic link stays and its target is replaced. Destroyed without commit,
// it leaves no trace; what a killed process left is swept by a later writer of the same file. The temporary
// name is the object's own: of several writers the last to commit wins, whole. System failures (disk full, no
// permission) throw std::system_error.
class AtomicFile {
  public:
    explicit AtomicFile(std::filesystem::path final_path);
    ~AtomicFile();
    AtomicFile(const AtomicFile&) = delete;
    AtomicFile& operator=(const AtomicFile&) = delete;

    const std::filesystem::path& temporary() const { return temporary_; }
    void commit();
    // As commit, and what had the final name before is kept under `previous`; at no moment are both missing.
    void commit_keeping(const std::filesystem::path& previous);

  private:
    std::filesystem::path final_, temporary_;
    bool committed_ = false;
};

// What killed writers have left in `folder`, if there is one; for its owner.
void remove_temporaries(const std::filesystem::path& folder);

// Writes a whole text file atomically.
void write_text(const std::filesystem::path& path, std::string_view text);

// Where a chain of symbolic links leads, whether there is something or not; `path` itself if it is no link.
std::filesystem::path link_target(std::filesystem::path path);

// fsync of a file or a folder.
void sync_to_disk(const std::filesystem::path& path);

// Before minutes of work, not after: can `folder` be made and written to? InputError when not.
void require_writable(const std::filesystem::path& folder);

// The same for a file that is written at the end of the work; an empty name asks for nothing.
void require_writable_file(const std::filesystem::path& file);

}  // namespace sandgraph::io
