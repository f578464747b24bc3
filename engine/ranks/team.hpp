#pragma once
#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

namespace sandgraph::ranks {

using Bytes = std::vector<std::uint8_t>;
using ByteSpan = std::span<const std::uint8_t>;

// Processes that compute the same macro step side by side, rank 0 with the outputs, and how bytes travel
// among them. `gather` and `broadcast` are called by all of them, in the same order; a call that fails does
// not return.
class Team {
  public:
    virtual ~Team() = default;
    virtual int rank() const = 0;
    virtual int size() const = 0;
    virtual int here() const = 0;  // ranks on this machine

    // All get what each gives, in the order of the ranks; `sizes` [ranks] [B] everybody knows beforehand.
    virtual void gather(ByteSpan mine, std::span<const std::size_t> sizes, std::span<std::uint8_t> all) = 0;
    virtual void broadcast(std::span<std::uint8_t> word) = 0;  // rank 0's
    virtual void send(int to, ByteSpan message) = 0;
    virtual Bytes receive(int from) = 0;

    // Ends all processes: one has failed at what the others wait for.
    [[noreturn]] virtual void abandon(const std::string& why) = 0;
};

}  // namespace sandgraph::ranks
