#pragma once
#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>

namespace sandgraph {

// Detects damage and names content; not cryptographic. Word-wise FNV-1a with a folding shift: both the
// multiply (odd) and the xor-shift are bijective, so two inputs of equal length that differ in one word never
// collide.
class Hasher {
  public:
    void add(std::span<const std::byte> bytes);
    std::uint64_t value() const;

  private:
    void word(std::uint64_t w);
    std::uint64_t state_ = 0xCBF29CE484222325ull, length_ = 0;
    std::uint64_t pending_ = 0;  // the last, incomplete word; filled from the low byte
    unsigned pending_bytes_ = 0;
};

std::uint64_t hash64(std::string_view text);
std::string hex(std::uint64_t value);  // 16 lower-case digits

}  // namespace sandgraph
