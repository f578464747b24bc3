#include "io/load_csv.hpp"

#include <fcntl.h>
#include <unistd.h>

#include <cerrno>
#include <string>
#include <system_error>
#include <utility>

#include "base/contracts.hpp"
#include "io/atomic_file.hpp"
#include "io/load_columns.hpp"

namespace sandgraph::io {

LoadCsv::LoadCsv(const std::filesystem::path& path, std::span<const LoadRow> rows, bool audited)
    : path_(path), audited_(audited) {
    std::string text = load_csv_header(audited) + '\n';
    for (const LoadRow& row : rows) text += load_csv_line(row, audited) + '\n';
    write_text(path, text);
    fd_ = ::open(path.c_str(), O_WRONLY | O_APPEND | O_CLOEXEC);
    if (fd_ < 0) throw std::system_error(errno, std::generic_category(), path.string() + ": cannot open");
}

LoadCsv::LoadCsv(LoadCsv&& other) noexcept
    : path_(std::move(other.path_)), audited_(other.audited_), fd_(std::exchange(other.fd_, -1)) {}

LoadCsv& LoadCsv::operator=(LoadCsv&& other) noexcept {
    std::swap(path_, other.path_);
    std::swap(audited_, other.audited_);
    std::swap(fd_, other.fd_);
    return *this;
}

LoadCsv::~LoadCsv() {
    if (fd_ >= 0) ::close(fd_);
}

void LoadCsv::append(const LoadRow& row) {
    SG_EXPECT(fd_ >= 0);
    const std::string line = load_csv_line(row, audited_) + '\n';
    if (::write(fd_, line.data(), line.size()) != static_cast<ssize_t>(line.size()))
        throw std::system_error(errno, std::generic_category(), path_.string() + ": cannot write");
}

}  // namespace sandgraph::io
