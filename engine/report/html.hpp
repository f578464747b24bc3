#pragma once
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace sandgraph::report {

// Pieces of a self-contained HTML page: text is escaped, pictures are embedded.
std::string base64(std::string_view bytes);

using Row = std::vector<std::string>;

// First row: head. Columns from the second on are aligned right when `numbers`. On a phone a table of more
// than three columns becomes a card a row. `links`: where the first cell of each row leads, "" nowhere.
std::string table(const std::vector<Row>& rows, bool numbers = true,
                  const std::vector<std::string>& links = {});

// The PNG as a data URI with a caption; a missing file becomes a line that says so. On a phone a picture
// wider than usual is panned, not shrunk to nothing.
std::string figure(const std::filesystem::path& png, std::string_view caption);

// "#..." to the element with that id.
std::string link_to(std::string_view id);

// Closed until the reader opens it.
std::string details(std::string_view summary, std::string_view inner_html);

// The whole document: style and body, nothing loaded from anywhere.
std::string page(std::string_view title, std::string_view body);

}  // namespace sandgraph::report
