#include "base/hash.hpp"

#include <fmt/format.h>

#include <cstring>

namespace sandgraph {
namespace {

std::uint64_t fold(std::uint64_t state, std::uint64_t w) {
    state = (state ^ w) * 0x9E3779B97F4A7C15ull;
    return state ^ (state >> 32);
}

}  // namespace

void Hasher::word(std::uint64_t w) { state_ = fold(state_, w); }

void Hasher::add(std::span<const std::byte> bytes) {
    length_ += bytes.size();
    std::size_t k = 0;
    while (k < bytes.size()) {
        if (pending_bytes_ == 0 && bytes.size() - k >= 8) {
            std::uint64_t w;
            std::memcpy(&w, bytes.data() + k, 8);
            word(w);
            k += 8;
            continue;
        }
        pending_ |= std::to_integer<std::uint64_t>(bytes[k++]) << (8 * pending_bytes_);
        if (++pending_bytes_ == 8) {
            word(pending_);
            pending_ = 0, pending_bytes_ = 0;
        }
    }
}

std::uint64_t Hasher::value() const { return fold(fold(state_, pending_), length_); }

std::uint64_t hash64(std::string_view text) {
    Hasher hasher;
    hasher.add(std::as_bytes(std::span(text.data(), text.size())));
    return hasher.value();
}

std::string hex(std::uint64_t value) { return fmt::format("{:016x}", value); }

}  // namespace sandgraph
