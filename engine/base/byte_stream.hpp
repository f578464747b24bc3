#pragma once
#include <cstdint>
#include <cstring>
#include <span>
#include <stdexcept>
#include <type_traits>
#include <vector>

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

// Throws std::runtime_error when the bytes end too early.
class ByteReader {
  public:
    explicit ByteReader(std::span<const std::uint8_t> in) : in_(in) {}
    template <class T>
    void take(T& value) {
        take(std::span<T>(&value, 1));
    }
    template <class T>
    void take(std::span<T> values) {
        static_assert(std::is_trivially_copyable_v<T>);
        if (values.size_bytes() > in_.size()) throw std::runtime_error("a checkpoint ends too early");
        if (!values.empty()) std::memcpy(values.data(), in_.data(), values.size_bytes());
        in_ = in_.subspan(values.size_bytes());
    }
    template <class T>
    void take(std::vector<T>& values) {
        std::uint64_t size = 0;
        take(size);
        if (size > in_.size()) throw std::runtime_error("a checkpoint ends too early");
        values.resize(size);
        take(std::span<T>(values));
    }
    bool empty() const { return in_.empty(); }

  private:
    std::span<const std::uint8_t> in_;
};

}  // namespace sandgraph
