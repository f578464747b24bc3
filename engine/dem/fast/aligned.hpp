#pragma once
#include <hwy/aligned_allocator.h>

#include <cstddef>
#include <cstring>
#include <span>
#include <vector>

namespace sandgraph::dem {

// A vector whose storage is aligned for any SIMD load.
template <class T>
struct AlignedAllocator {
    using value_type = T;
    AlignedAllocator() = default;
    template <class U>
    AlignedAllocator(const AlignedAllocator<U>&) {}
    T* allocate(std::size_t n) {
        return static_cast<T*>(hwy::AllocateAlignedBytes(n * sizeof(T), nullptr, nullptr));
    }
    void deallocate(T* p, std::size_t) { hwy::FreeAlignedBytes(p, nullptr, nullptr); }
    friend bool operator==(const AlignedAllocator&, const AlignedAllocator&) { return true; }
};
template <class T>
using Aligned = std::vector<T, AlignedAllocator<T>>;

}  // namespace sandgraph::dem
