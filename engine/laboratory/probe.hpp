#pragma once
#include <filesystem>

#include "dem/prepare/prepare.hpp"
#include "scene/probe_spec.hpp"

namespace sandgraph::laboratory {

// Prepares the recipe's packings (or takes them from the cache), drives its strain paths in parallel and
// writes the history log to `out`; the same bytes of data at any thread count.
void write_probe(const scene::ProbeSpec& spec, const std::filesystem::path& out,
                 const ProgressCallback& progress = {});

}  // namespace sandgraph::laboratory
