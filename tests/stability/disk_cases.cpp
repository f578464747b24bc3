#include <fmt/format.h>
#include <sys/mount.h>

#include <algorithm>
#include <array>
#include <fstream>

#include "base/error.hpp"
#include "base/random.hpp"
#include "io/checkpoint.hpp"
#include "io/run_record.hpp"
#include "stability/run_digest.hpp"
#include "stability/run_folder.hpp"

namespace sandgraph::stability {
namespace {

namespace fs = std::filesystem;

// Lines that the run ends with, from its error on: one.
double lines_of_error(const std::string& log) {
    const std::size_t at = log.find("sandgraph: ");
    return at == std::string::npos
               ? 0
               : static_cast<double>(std::count(log.begin() + static_cast<long>(at), log.end(), '\n'));
}

// A disk that is full for one run and has room again for the next.
void check_full(const RunFolder& folder, const std::string& name, int code, Findings& found) {
    found.exactly("exit code when it is full", code, 1);
    found.exactly("messages", lines_of_error(folder.log(name)), 1);
    found.exactly("a checkpoint is left", folder.can_resume(name), 1);
}

void size_limit(Effort effort, Findings& found) {
    found.driven = "no file may grow past 200 kB once the run has a checkpoint; then room again and --resume";
    const RunFolder folder(effort, RunMode::full);
    folder.run("whole");
    int code = folder.run("full", {"--until", "0.01"});
    found.exactly("exit code of the first part", code, 0);
    code = folder.run("full", {"--resume"}, {.file_size = 200'000});
    check_full(folder, "full", code, found);
    found.exactly("exit code of the resumed run", folder.run("full", {"--resume"}), 0);
    check_same("the uninterrupted run", differences(digest(folder / "whole"), digest(folder / "full")),
               found);
}

// A disk of its own at a folder, as long as it lives.
class SmallDisk {
  public:
    SmallDisk(std::string folder, const char* size)
        : folder_(std::move(folder)), mounted_(mount("tmpfs", folder_.c_str(), "tmpfs", 0, size) == 0) {}
    ~SmallDisk() {
        if (mounted_) umount2(folder_.c_str(), MNT_DETACH);
    }
    SmallDisk(const SmallDisk&) = delete;
    SmallDisk& operator=(const SmallDisk&) = delete;
    bool mounted() const { return mounted_; }
    void grow(const char* size) { mount("tmpfs", folder_.c_str(), "tmpfs", MS_REMOUNT, size); }

  private:
    std::string folder_;
    bool mounted_;
};

void full_disk(Effort effort, Findings& found) {
    const RunFolder folder(effort, RunMode::full);
    fs::create_directories(folder / "disk");
    SmallDisk disk((folder / "disk").string(), "size=1200k");
    found.driven = "a run folder on a disk of 1.2 MB that runs full; then the disk grows and --resume";
    found.note("disk mounted (0: this user may not)", disk.mounted());
    if (!disk.mounted()) return;
    folder.run("whole");
    check_full(folder, "disk/full", folder.run("disk/full"), found);
    disk.grow("size=100m");
    found.exactly("exit code of the resumed run", folder.run("disk/full", {"--resume"}), 0);
    check_same("the uninterrupted run", differences(digest(folder / "whole"), digest(folder / "disk/full")),
               found);
}

// Each fill level lets another write fail: of a packing, the log, the checkpoint, run.h5.
void full_disks(Effort effort, Findings& found) {
    const int sizes = effort == Effort::quick ? 8 : 100;
    const RunFolder folder(effort, RunMode::full);
    fs::create_directories(folder / "disk");
    found.driven = fmt::format("the same on disks of {} sizes from 0.4 to 1.8 MB", sizes);
    int told = 0;
    for (int k = 0; k < sizes; ++k) {
        const SmallDisk disk((folder / "disk").string(),
                             fmt::format("size={}k", 400 + 1400 * k / sizes).c_str());
        if (!disk.mounted()) return found.note("disk mounted (0: this user may not)", 0);
        told += folder.run("disk/full") == 1 && lines_of_error(folder.log("disk/full")) == 1;
    }
    found.exactly("ends with exit code 1 and one message", told, sizes);
}

void no_folder(Effort effort, Findings& found) {
    found.driven = "run folders that cannot be: under /proc, below a file, taken away in mid-run";
    const RunFolder folder(effort, RunMode::full);
    std::ofstream(folder / "file") << "in the way";
    found.exactly("exit code under /proc", folder.run("/proc/sandgraph"), 2);
    found.exactly("exit code below a file", folder.run("file/below"), 2);
    const pid_t pid = folder.start("gone");
    folder.await_checkpoint(pid, "gone");
    fs::rename(folder / "gone", folder / "elsewhere");
    found.exactly("exit code when it is taken away", support::finish_program(pid), 1);
    found.exactly("messages", lines_of_error(folder.log("gone")), 1);
    fs::rename(folder / "elsewhere", folder / "gone");
    found.exactly("exit code of --resume when it is back", folder.run("gone", {"--resume"}), 0);
}

void flip(const fs::path& file, std::uintmax_t at) {
    std::fstream f(file, std::ios::in | std::ios::out | std::ios::binary);
    f.seekg(static_cast<std::streamoff>(at));
    const char byte = static_cast<char>(f.get() ^ 0x10);
    f.seekp(static_cast<std::streamoff>(at));
    f.put(byte);
}

// Reading a checkpoint damaged in one place: is the one before it taken, with a notice?
bool previous_taken(const fs::path& checkpoint, const std::string& scene_hash) {
    const io::CheckpointReader reader(checkpoint, scene_hash);
    return reader.notice().find(".prev") != std::string::npos;
}

void damaged(Effort effort, Findings& found) {
    const int flips = effort == Effort::quick ? 50 : 1000;
    found.driven =
        fmt::format("the last checkpoint cut short, or with one bit flipped at {} random places", flips);
    const RunFolder folder(effort, RunMode::full);
    folder.run("whole");
    const pid_t pid = folder.start("part", {"--until", "0.02"});
    folder.await_checkpoint(pid, "part", true);
    support::finish_program(pid);
    const fs::path checkpoint = folder / "part" / io::checkpoint_name, copy = folder / "copy.h5";
    const std::string hash = io::read_run(folder / "part" / "run.h5").info.scene_hash;
    fs::copy_file(checkpoint, copy);
    Random random(3);
    int taken = 0;
    for (int k = 0; k < flips; ++k) {
        const auto at =
            static_cast<std::uintmax_t>(random.uniform() * static_cast<double>(fs::file_size(copy)));
        flip(checkpoint, at);
        taken += previous_taken(checkpoint, hash);
        flip(checkpoint, at);
    }
    found.exactly("flips after which the one before was taken", taken, flips);
    fs::resize_file(checkpoint, fs::file_size(copy) / 2);
    found.exactly("exit code of --resume with half a checkpoint", folder.run("part", {"--resume"}), 0);
    found.exactly("says that it takes the one before",
                  folder.log("part").find("going on from the one before it") != std::string::npos, 1);
    check_same("the uninterrupted run", differences(digest(folder / "whole"), digest(folder / "part")),
               found);
    const pid_t other = folder.start("both", {"--until", "0.02"});
    folder.await_checkpoint(other, "both", true);
    support::finish_program(other);
    for (const fs::path& file : {folder / "both" / io::checkpoint_name,
                                 io::previous_checkpoint(folder / "both" / io::checkpoint_name)})
        flip(file, fs::file_size(file) / 2);
    found.exactly("exit code of --resume when both are damaged", folder.run("both", {"--resume"}), 2);
}

constexpr std::array table = {Case{"lost.size_limit", size_limit}, Case{"lost.full_disk", full_disk},
                              Case{"lost.full_disks", full_disks}, Case{"lost.no_folder", no_folder},
                              Case{"lost.damaged", damaged}};

}  // namespace

std::span<const Case> disk_cases() { return table; }

}  // namespace sandgraph::stability
