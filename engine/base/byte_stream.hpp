#pragma once
#include <cstdint>
#include <cstring>
#include <span>
#include <type_traits>
#include <vector>

#include "base/error.hpp"

namespace sandgraph {

// Plain values one behind the other, for checkpoints of many small objects. The order of put and take must
// match.
class ByteWriter {
  public:
    explicit ByteWriter(std::vector<std::uint8_t>& out) : out_(out) {}
    template <class T>
    void put(const T& value) {
        put(std::span<const T>(&value, 1));
    }
    template <class T>
    void put(std::span<const T> values) {
        static_assert(std::is_trivially_copyable_v<T>);
        const std::size_t end = out_.size();
        out_.resize(end + values.size_bytes());
        if (!values.empty()) std::memcpy(out_.data() + end, values.data(), values.size_bytes());
    }
    // A vector with its length in front.
    template <class T>
    void put(const std::vector<T>& values) {
        put(static_cast<std::uint64_t>(values.size()));
        put(std::span<const T>(values));
    }

  private:
    std::vector<std::uint8_t>& out_;
};

// Throws StateError when the bytes end too early or cannot be what is asked for.
class ByteReader {
  public:
    explicit ByteReader(std::span<const std::uint8_t> in) : in_(in) {}
    template <class T>
    void take(T& value) {
        take(std::span<T>(&value, 1));
    }
    void take(bool& value) {
        std::uint8_t byte = 0;
        take(byte);
        require_state(byte <= 1, "flags");
        value = byte != 0;
    }
    template <class T>
    void take(std::span<T> values) {
        static_assert(std::is_trivially_copyable_v<T>);
        require_state(values.size_bytes() <= in_.size(), "lengths");
        if (!values.empty()) std::memcpy(values.data(), in_.data(), values.size_bytes());
        in_ = in_.subspan(values.size_bytes());
    }
    template <class T>
    void take(std::vector<T>& values) {
        values.resize(take_size<T>());
        take(std::span<T>(values));
    }
    // A vector that has its length already.
    template <class T>
    void take_same(std::vector<T>& values) {
        require_state(take_size<T>() == values.size(), "lengths");
        take(std::span<T>(values));
    }
    bool empty() const { return in_.empty(); }

  private:
    template <class T>
    std::size_t take_size() {
        std::uint64_t size = 0;
        take(size);
        require_state(size <= in_.size() / sizeof(T), "lengths");
        return size;
    }
    std::span<const std::uint8_t> in_;
};

}  // namespace sandgraph
