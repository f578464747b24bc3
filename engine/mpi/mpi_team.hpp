#pragma once
#include "ranks/team.hpp"

namespace sandgraph::mpi {

// The processes that mpirun (or srun) has started together. One object a process, as long as it uses MPI:
// calls come from any thread, never from two at once.
class MpiTeam final : public ranks::Team {
  public:
    MpiTeam(int& argc, char**& argv);
    ~MpiTeam() override;
    MpiTeam(const MpiTeam&) = delete;
    MpiTeam& operator=(const MpiTeam&) = delete;

    int rank() const override { return rank_; }
    int size() const override { return size_; }
    int here() const override { return here_; }
    void gather(ranks::ByteSpan mine, std::span<const std::size_t> sizes,
                std::span<std::uint8_t> all) override;
    void broadcast(std::span<std::uint8_t> word) override;
    void send(int to, ranks::ByteSpan message) override;
    ranks::Bytes receive(int from) override;
    [[noreturn]] void abandon(const std::string& why) override;

  private:
    int rank_ = 0, size_ = 1, here_ = 1;
    std::vector<int> counts_, begins_;  // of the last gather, by rank [B]
};

}  // namespace sandgraph::mpi
