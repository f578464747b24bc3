#pragma once
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <string>
#include <string_view>
#include <vector>

#include "base/error.hpp"

namespace sandgraph {

// Reads comma-separated values as people and their programs write them: lines that end in CRLF, a byte order
// mark, blanks or quotes around cells, empty lines, comment lines that begin with '#'.
class CsvReader {
  public:
    // InputError when the file cannot be read.
    explicit CsvReader(const std::filesystem::path& file);

    bool next();      // goes to the next line with something on it; false at the end
    bool next_row();  // the same, past comments
    bool comment() const { return text_.starts_with('#'); }

    const std::string& text() const { return text_; }  // without blanks at both ends
    std::vector<std::string_view> cells() const;       // of the line, without blanks and quotes at both ends
    int line() const { return line_; }                 // counted from 1
    InputError::Where where() const { return {name_, line_}; }
    [[noreturn]] void refuse(const std::string& problem, const std::string& why,
                             const std::string& suggestion) const;

    // "0.1", "+1", "1e-3", "nan"; InputError at this line for anything else. The integer has no point.
    double number(std::string_view cell) const;
    std::int64_t integer(std::string_view cell) const;

  private:
    std::string name_;
    std::ifstream stream_;
    std::string text_;
    int line_ = 0;
};

}  // namespace sandgraph
