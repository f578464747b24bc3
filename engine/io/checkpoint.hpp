#pragma once
#include <filesystem>
#include <string>

#include "base/archive.hpp"
#include "io/atomic_file.hpp"
#include "io/h5_file.hpp"

namespace sandgraph::io {

inline constexpr const char* checkpoint_name = "checkpoint.h5";  // in the run folder

// What a checkpoint belongs to.
struct CheckpointHeader {
    std::string scene_hash, git;
    double d_over_B = 0;
};

std::filesystem::path previous_checkpoint(const std::filesystem::path& path);  // PATH.prev

// Removes PATH and PATH.prev.
void remove_checkpoints(const std::filesystem::path& path);

// Writes a checkpoint beside PATH; commit() seals it, brings it to the disk and renames it, and the
// checkpoint before it stays as PATH.prev. Killed at any moment, PATH or PATH.prev is whole.
class CheckpointWriter : public Archive {
  public:
    CheckpointWriter(const std::filesystem::path& path, const CheckpointHeader& header);
    bool reading() const override { return false; }
    void field(std::string_view name, std::vector<double>& values) override;
    void field(std::string_view name, std::vector<std::int64_t>& values) override;
    void field(std::string_view name, std::vector<std::uint8_t>& values) override;
    void commit();

  private:
    std::filesystem::path path_;
    AtomicFile target_;
    h5::File file_;
    h5::Group state_;
};

// Reads a whole, undamaged checkpoint of the given scene; PATH.prev when PATH is damaged or missing.
// InputError when neither is whole, or it belongs to another scene, or its schema is another.
class CheckpointReader : public Archive {
  public:
    CheckpointReader(const std::filesystem::path& path, const std::string& scene_hash);
    bool reading() const override { return true; }
    void field(std::string_view name, std::vector<double>& values) override;
    void field(std::string_view name, std::vector<std::int64_t>& values) override;
    void field(std::string_view name, std::vector<std::uint8_t>& values) override;

    const CheckpointHeader& header() const { return header_; }
    // One line for the user when the previous checkpoint had to be taken; else empty.
    const std::string& notice() const { return notice_; }

  private:
    std::string notice_;
    h5::File file_;
    h5::Group state_;
    CheckpointHeader header_;
};

}  // namespace sandgraph::io
