#pragma once
#include <cstdint>
#include <string_view>

namespace sandgraph {

// FNV-1a, 64 bit (Fowler, Noll & Vo): the same on every machine; not for secrets.
constexpr std::uint64_t fnv1a(std::string_view bytes, std::uint64_t hash = 0xCBF29CE484222325ull) {
    for (const char byte : bytes) hash = (hash ^ static_cast<unsigned char>(byte)) * 0x100000001B3ull;
    return hash;
}

}  // namespace sandgraph
