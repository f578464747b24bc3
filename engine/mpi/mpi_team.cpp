#include "mpi/mpi_team.hpp"

#include <fmt/format.h>
#include <mpi.h>

#include <cstdlib>
#include <limits>
#include <stdexcept>

#include "base/console.hpp"
#include "base/contracts.hpp"

// MPI's own error handler stays: it ends all ranks.
namespace sandgraph::mpi {
namespace {

constexpr int kTag = 0;

int count_of(std::size_t bytes) {
    if (bytes > std::size_t(std::numeric_limits<int>::max()))
        throw std::length_error(fmt::format("{} bytes are more than one MPI message takes", bytes));
    return static_cast<int>(bytes);
}

int ranks_on_this_machine() {
    MPI_Comm here = MPI_COMM_NULL;
    MPI_Comm_split_type(MPI_COMM_WORLD, MPI_COMM_TYPE_SHARED, 0, MPI_INFO_NULL, &here);
    int count = 1;
    MPI_Comm_size(here, &count);
    MPI_Comm_free(&here);
    return count;
}

}  // namespace

MpiTeam::MpiTeam(int& argc, char**& argv) {
    int provided = MPI_THREAD_SINGLE;
    MPI_Init_thread(&argc, &argv, MPI_THREAD_SERIALIZED, &provided);
    MPI_Comm_rank(MPI_COMM_WORLD, &rank_);
    MPI_Comm_size(MPI_COMM_WORLD, &size_);
    here_ = ranks_on_this_machine();
    if (provided < MPI_THREAD_SERIALIZED) abandon("this MPI library knows no threads");
}

MpiTeam::~MpiTeam() { MPI_Finalize(); }

void MpiTeam::gather(ranks::ByteSpan mine, std::span<const std::size_t> sizes, std::span<std::uint8_t> all) {
    SG_EXPECT(std::ssize(sizes) == size_ && mine.size() == sizes[static_cast<std::size_t>(rank_)]);
    counts_.clear(), begins_.clear();
    std::size_t begin = 0;
    for (const std::size_t size : sizes) {
        counts_.push_back(count_of(size)), begins_.push_back(count_of(begin));
        begin += size;
    }
    SG_EXPECT(all.size() == begin);
    MPI_Allgatherv(mine.data(), counts_[static_cast<std::size_t>(rank_)], MPI_BYTE, all.data(),
                   counts_.data(), begins_.data(), MPI_BYTE, MPI_COMM_WORLD);
}

void MpiTeam::broadcast(std::span<std::uint8_t> word) {
    MPI_Bcast(word.data(), count_of(word.size()), MPI_BYTE, 0, MPI_COMM_WORLD);
}

void MpiTeam::send(int to, ranks::ByteSpan message) {
    MPI_Send(message.data(), count_of(message.size()), MPI_BYTE, to, kTag, MPI_COMM_WORLD);
}

ranks::Bytes MpiTeam::receive(int from) {
    MPI_Status status;
    MPI_Probe(from, kTag, MPI_COMM_WORLD, &status);
    int count = 0;
    MPI_Get_count(&status, MPI_BYTE, &count);
    ranks::Bytes out(static_cast<std::size_t>(count));
    MPI_Recv(out.data(), count, MPI_BYTE, from, kTag, MPI_COMM_WORLD, MPI_STATUS_IGNORE);
    return out;
}

void MpiTeam::abandon(const std::string& why) {
    notice(fmt::format("sandgraph: rank {} of {}: {}; what has a checkpoint goes on with --resume", rank_,
                       size_, why));
    MPI_Abort(MPI_COMM_WORLD, 1);
    std::abort();
}

}  // namespace sandgraph::mpi
