#include "io/checkpoint.hpp"

#include <fmt/format.h>

#include "base/error.hpp"
#include "io/content.hpp"
#include "io/h5_attribute.hpp"
#include "io/h5_dataset.hpp"

namespace sandgraph::io {
namespace fs = std::filesystem;
namespace {

constexpr std::int64_t schema = 1;

template <class T>
void write_field(h5::Group& state, std::string_view name, const std::vector<T>& values) {
    h5::write(state, name, std::span<const T>(values), {values.size()}, "", h5::Storage::contiguous);
}

std::optional<std::string> damage(const fs::path& path) {
    if (!fs::exists(path)) return "missing";
    return broken_seal(path);
}

// The newest whole checkpoint.
fs::path choose(const fs::path& path, std::string& notice) {
    const auto problem = damage(path);
    if (!problem) return path;
    const fs::path previous = previous_checkpoint(path);
    const auto previous_problem = damage(previous);
    if (previous_problem)
        throw InputError(
            {path.string()}, "no whole checkpoint",
            fmt::format("it is {}, {} is {}", *problem, previous.filename().string(), *previous_problem),
            "start the run anew, without --resume");
    notice = fmt::format("{}: {}; going on from the one before it, {}", path.string(), *problem,
                         previous.string());
    return previous;
}

CheckpointHeader read_header(const h5::Group& root, const std::string& scene_hash) {
    require_content(root, "checkpoint", schema);
    const CheckpointHeader header{h5::get_text(root, ".", "scene_hash"), h5::get_text(root, ".", "git"),
                                  h5::get_real(root, ".", "d_over_B")};
    if (header.scene_hash != scene_hash)
        throw InputError({root.file()}, "the checkpoint belongs to another scene",
                         fmt::format("scene hash {} instead of {}", header.scene_hash, scene_hash),
                         "resume with the unchanged scene, or start anew in another folder");
    return header;
}

}  // namespace

fs::path previous_checkpoint(const fs::path& path) { return path.string() + ".prev"; }

void remove_checkpoints(const fs::path& path) {
    fs::remove(path);
    fs::remove(previous_checkpoint(path));
}

CheckpointWriter::CheckpointWriter(const fs::path& path, const CheckpointHeader& header)
    : path_(path),
      target_(path),
      file_(h5::File::create(target_.temporary(), seal_size)),
      state_(file_.root().create("state")) {
    h5::Group root = file_.root();
    mark_content(root, "checkpoint", schema);
    h5::set_attribute(root, ".", "scene_hash", header.scene_hash);
    h5::set_attribute(root, ".", "git", header.git);
    h5::set_attribute(root, ".", "d_over_B", header.d_over_B);
}

void CheckpointWriter::field(std::string_view n, std::vector<double>& v) { write_field(state_, n, v); }
void CheckpointWriter::field(std::string_view n, std::vector<std::int64_t>& v) { write_field(state_, n, v); }
void CheckpointWriter::field(std::string_view n, std::vector<std::uint8_t>& v) { write_field(state_, n, v); }

void CheckpointWriter::commit() {
    file_.close();
    seal(target_.temporary());
    // A damaged checkpoint must not push a whole one out.
    if (damage(path_)) return target_.commit();
    target_.commit_keeping(previous_checkpoint(path_));
}

CheckpointReader::CheckpointReader(const fs::path& path, const std::string& scene_hash)
    : file_(h5::File::open(choose(path, notice_))),
      state_(file_.root().open("state")),
      header_(read_header(file_.root(), scene_hash)) {}

void CheckpointReader::field(std::string_view n, std::vector<double>& v) { v = h5::read<double>(state_, n); }
void CheckpointReader::field(std::string_view n, std::vector<std::int64_t>& v) {
    v = h5::read<std::int64_t>(state_, n);
}
void CheckpointReader::field(std::string_view n, std::vector<std::uint8_t>& v) {
    v = h5::read<std::uint8_t>(state_, n);
}

}  // namespace sandgraph::io
