#include "packings/load_packing.hpp"

#include <filesystem>

#include "base/error.hpp"
#include "dem/packing/csv.hpp"

namespace sandgraph::packings {

io::PackingRecord load_packing(const std::string& file) {
    const std::string kind = std::filesystem::path(file).extension().string();
    if (kind == ".csv") return {.packing = dem::read_packing_csv(file), .material = {}, .recipe = {}};
    if (kind == ".h5") return io::read_packing(file);
    throw InputError({file, 0}, "unknown kind of packing file", "its name must tell the format",
                     "give a .csv or .h5 file");
}

}  // namespace sandgraph::packings
