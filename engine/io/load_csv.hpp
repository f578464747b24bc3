#pragma once
#include <filesystem>
#include <span>

#include "io/frame.hpp"

namespace sandgraph::io {

// load.csv as the run goes on: each row is handed to the system in one write, so a killed run keeps every
// row.
class LoadCsv {
  public:
    // Writes header and rows atomically and stays open behind them.
    LoadCsv(const std::filesystem::path& path, std::span<const LoadRow> rows, bool audited);
    ~LoadCsv();
    LoadCsv(LoadCsv&& other) noexcept;
    LoadCsv& operator=(LoadCsv&& other) noexcept;
    void append(const LoadRow& row);

  private:
    std::filesystem::path path_;
    bool audited_;
    int fd_ = -1;
};

}  // namespace sandgraph::io
