#pragma once
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "io/h5_group.hpp"

namespace sandgraph::io::h5 {

using Shape = std::vector<std::size_t>;

// Contiguous: fastest, no checksum of its own. Packed: chunked, byte-shuffled, deflated, Fletcher-32 checked.
// Growing: as packed, with no limit along the first axis.
enum class Storage { contiguous, packed, growing };

// T: double, float, std::int64_t, std::int32_t, std::int16_t, std::uint8_t. values in row-major order; a name
// with '/' makes the groups in between. unit "" stores no unit attribute.
template <class T>
void write(Group& group, std::string_view name, std::span<const T> values, const Shape& shape,
           std::string_view unit = "", Storage storage = Storage::packed);

// A growing dataset gets `values`, whole rows of it, appended along its first axis.
template <class T>
void append(Group& group, std::string_view name, std::span<const T> values);

// Cuts a growing dataset to its first `size` rows (InputError when it is shorter).
void truncate(Group& group, std::string_view name, std::size_t size);

// InputError when missing, damaged, or not of T's class (real or integer) and size.
template <class T>
std::vector<T> read(const Group& group, std::string_view name);

Shape shape(const Group& group, std::string_view name);
// As info() prints it: "float64", "int32", "uint8", ...
std::string type_name(const Group& group, std::string_view name);

}  // namespace sandgraph::io::h5
