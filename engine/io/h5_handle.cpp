#include "io/h5_handle.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>

namespace sandgraph::io::h5 {
namespace {

// H5E_WALK_UPWARD starts at the innermost frame, which names the cause.
herr_t first_description(unsigned n, const H5E_error2_t* error, void* text) {
    if (n == 0 && error->desc) *static_cast<std::string*>(text) = error->desc;
    return 0;
}

}  // namespace

// Nor does HDF5 clean up at exit: what we write we close ourselves, and with a file that could not be written
// (disk full) it crashes there.
void silence() {
    [[maybe_unused]] static const bool first = H5dont_atexit() >= 0;
    H5Eset_auto2(H5E_DEFAULT, nullptr, nullptr);
}

std::string last_error() {
    std::string text;
    H5Ewalk2(H5E_DEFAULT, H5E_WALK_UPWARD, first_description, &text);
    H5Eclear2(H5E_DEFAULT);
    std::replace(text.begin(), text.end(), '\n', ' ');  // an error of ours is one line
    return text.empty() ? "no further detail from HDF5" : text;
}

void check(long long status, const std::string& file, const std::string& action) {
    if (status >= 0) return;
    throw std::runtime_error(fmt::format("{}: cannot {} (HDF5: {})", file, action, last_error()));
}

Handle own(hid_t id, Handle::Close close, const std::string& file, const std::string& action) {
    check(id, file, action);
    return Handle(id, close);
}

}  // namespace sandgraph::io::h5
