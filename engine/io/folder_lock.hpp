#pragma once
#include <filesystem>

namespace sandgraph::io {

// One owner a folder of results: two runs in one folder would mix their files without a word. The lock is the
// kernel's (flock), so it dies with its process, however that ends; children that are started do not inherit
// it.
class FolderLock {
  public:
    // Makes the folder if there is none. InputError when another process has it (its name and start are told)
    // or when it cannot be made or written. On a file system without locks a notice takes the lock's place.
    explicit FolderLock(std::filesystem::path folder);
    // Gives the folder back; takes it away if it was made here and nothing has been put into it.
    ~FolderLock();
    FolderLock(const FolderLock&) = delete;
    FolderLock& operator=(const FolderLock&) = delete;

  private:
    std::filesystem::path folder_;
    std::filesystem::path made_;  // the topmost folder that was made here; empty: none
    int fd_ = -1;
};

}  // namespace sandgraph::io
