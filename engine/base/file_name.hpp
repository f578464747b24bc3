#pragma once
#include <string>

namespace sandgraph {

// ".h5" of "dir/P.H5": the extension in small letters, with its dot; empty without one.
std::string extension_of(const std::string& file);

// Refuses with InputError a `file` to be written whose name tells another kind than `extension` (".csv"):
// that of another kind of file, ".png" for a table. An empty name, one without an extension and an unknown
// one pass. With `always` the name must end so, since readers go by it.
enum class Naming { usual, always };
void require_extension(const std::string& file, const std::string& extension, Naming naming = Naming::usual);

}  // namespace sandgraph
